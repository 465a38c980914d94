/** Transport controls: pause, step, speed, reset, and the real-time factor. */
import { neighbourSpeed, SPEEDS, transport } from '../state/studio-state.js';
import { button, byId, choice, element, setText } from './elements.js';

/**
 * @typedef {import('../state/studio-state.js').StudioState} StudioState
 * @typedef {(command: object) => void} Send
 * @typedef {ReturnType<typeof timeActions>} Actions
 */

/** Explains why time cannot be stopped through a monitor port. */
export const NO_CLOCK = 'The watched server has its own clock; a monitor cannot stop it.';

/**
 * Actions of the time controls, shared by buttons and keys.
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
    undo: () => send({ do: 'undo' }),
    redo: () => send({ do: 'redo' }),
  };
}

/**
 * @param {Actions} actions
 * @returns {(state: StudioState) => void} function that updates the controls
 */
export function transportPanel(actions) {
  const parts = partsOf(actions);
  const { toggle, step, reset, undo, redo, speed, seconds, cycle, factor, why } = parts;
  const speedLabel = element('label', { class: 'speed' }, element('span', {}, 'Speed'), speed);
  byId('transport').append(
    element('div', { class: 'buttons' }, toggle, step, reset, undo, redo, speedLabel),
    element('div', { class: 'reading' }, seconds, cycle, factor),
    why,
  );
  return (state) => {
    const shown = transport(state);
    drawControls(parts, shown, state.scene?.clock !== false);
    for (const part of [toggle, step, reset, undo, redo, speedLabel]) {
      part.hidden = state.scene?.match === false;
    }
    reset.disabled = state.connection !== 'live' || !state.frame;
    drawUndo(undo, 'Undo', state.actions.undo, 'Ctrl+Z');
    drawUndo(redo, 'Redo', state.actions.redo, 'Ctrl+Shift+Z');
    setText(seconds, shown.seconds);
    setText(cycle, shown.cycle);
    setText(factor, shown.realTimeFactor);
  };
}

/** @param {Actions} actions */
function partsOf(actions) {
  const speeds = SPEEDS.map((each) => /** @type {[string, string]} */ ([String(each), speedText(each)]));
  const resetHint = 'Resets robots, ball, time and score (R)';
  return {
    toggle: button('', '', actions.toggle, { id: 'toggle', class: 'primary' }),
    step: button('Step', '', () => actions.step(1), { id: 'step' }),
    reset: button('Reset', resetHint, actions.reset, { id: 'reset' }),
    undo: button('↶', '', actions.undo, { id: 'world-undo', 'aria-label': 'Undo' }),
    redo: button('↷', '', actions.redo, { id: 'world-redo', 'aria-label': 'Redo' }),
    speed: choice({ id: 'speed', 'aria-label': 'Speed' }, speeds, actions.speed),
    seconds: element('span', { class: 'seconds' }),
    cycle: element('span', { class: 'faint' }),
    factor: element('span', { class: 'faint', title: 'Simulated seconds per second' }),
    why: element('p', { class: 'faint', id: 'no-clock' }, NO_CLOCK),
  };
}

/** @param {HTMLButtonElement} control @param {string} verb @param {string} action @param {string} keys */
function drawUndo(control, verb, action, keys) {
  control.disabled = action === '';
  control.title = action === '' ? `Nothing to ${verb.toLowerCase()} (${keys})` : `${verb}: ${action} (${keys})`;
}

/** @param {string | number} speed */
function speedText(speed) {
  return speed === 'fastest' ? 'as fast as possible' : `${speed}×`;
}

/** @param {ReturnType<typeof partsOf>} parts @param {ReturnType<typeof transport>} shown @param {boolean} hasClock */
function drawControls({ toggle, step, speed, why }, shown, hasClock) {
  setText(toggle, shown.paused ? '▶ Play' : '❚❚ Pause');
  toggle.title = hasClock ? `${shown.paused ? 'Let time run' : 'Stop the clock'} (space)` : NO_CLOCK;
  step.title = hasClock ? 'One cycle of 20 ms, then pause (.)' : NO_CLOCK;
  speed.title = hasClock ? 'How fast time passes (+ and −)' : NO_CLOCK;
  why.hidden = hasClock;
  for (const control of [toggle, step, speed]) {
    control.disabled = !shown.enabled;
  }
  if (shown.speed !== undefined && document.activeElement !== speed) {
    speed.value = String(shown.speed);
  }
}
