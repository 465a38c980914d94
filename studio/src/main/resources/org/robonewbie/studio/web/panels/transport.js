/** Pause, step, speed, reset, and how fast the world runs. */
import { neighbourSpeed, SPEEDS, transport } from '../state/studio-state.js';
import { button, byId, element, setText } from './elements.js';

/**
 * @typedef {import('../state/studio-state.js').StudioState} StudioState
 * @typedef {(command: object) => void} Send
 */

/** Why time cannot be stopped when one looks through a monitor port. */
export const NO_CLOCK = 'The server that is watched keeps its own clock; a monitor cannot stop it.';

/**
 * What the time controls do; shared by buttons and keys.
 *
 * @param {() => StudioState} now
 * @param {Send} send
 */
export function timeActions(now, send) {
  const speed = () => now().frame?.speed ?? 1;
  return {
    toggle: () => send({ do: transport(now()).paused ? 'resume' : 'pause' }),
    /** @param {number} cycles */
    step: (cycles) => send({ do: 'step', cycles }),
    faster: () => send({ do: 'speed', factor: neighbourSpeed(speed(), 1) }),
    slower: () => send({ do: 'speed', factor: neighbourSpeed(speed(), -1) }),
    /** @param {string} factor */
    speed: (factor) => send({ do: 'speed', factor: factor === 'fastest' ? factor : Number(factor) }),
    reset: () => send({ do: 'reset' }),
  };
}

/**
 * @param {ReturnType<typeof timeActions>} actions
 * @returns {(state: StudioState) => void} draws the controls
 */
export function transportPanel(actions) {
  const toggle = button('', '', actions.toggle);
  toggle.id = 'toggle';
  toggle.className = 'primary';
  const step = button('Step', '', () => actions.step(1));
  step.id = 'step';
  const reset = button('Reset', 'Robots, ball, time and score back to the start (R)', actions.reset);
  reset.id = 'reset';
  const speed = element('select', { id: 'speed', 'aria-label': 'Speed' });
  for (const each of SPEEDS) {
    const name = each === 'fastest' ? 'as fast as possible' : `${each}×`;
    speed.append(element('option', { value: String(each) }, name));
  }
  speed.addEventListener('change', () => actions.speed(speed.value));
  const seconds = element('span', { class: 'seconds' });
  const cycle = element('span', { class: 'faint' });
  const factor = element('span', { class: 'faint', title: 'Simulated seconds per second' });
  const why = element('p', { class: 'faint', id: 'no-clock' }, NO_CLOCK);
  byId('transport').append(
    element('div', { class: 'buttons' }, toggle, step, reset, element('label', { class: 'speed' }, 'Speed', speed)),
    element('div', { class: 'reading' }, seconds, cycle, factor),
    why,
  );
  return (state) => {
    const shown = transport(state);
    setText(toggle, shown.paused ? '▶ Play' : '❚❚ Pause');
    const hasClock = state.scene?.clock !== false;
    toggle.title = hasClock ? `${shown.paused ? 'Let time run' : 'Stop the clock'} (space)` : NO_CLOCK;
    step.title = hasClock ? 'One cycle of 20 ms, then pause (.)' : NO_CLOCK;
    speed.title = hasClock ? 'How fast time passes (+ and −)' : NO_CLOCK;
    why.hidden = hasClock;
    for (const control of [toggle, step, speed]) {
      control.disabled = !shown.enabled;
    }
    reset.disabled = state.connection !== 'live' || !state.frame;
    if (shown.speed !== undefined && document.activeElement !== speed) {
      speed.value = String(shown.speed);
    }
    setText(seconds, shown.seconds);
    setText(cycle, shown.cycle);
    setText(factor, shown.realTimeFactor);
  };
}
