/** The buttons of the motion editor. */
import { button, element, setText } from '../panels/elements.js';
import { framesOf, isUnsaved, lengthOf, postureNow } from '../state/motion/editor-state.js';
import { balanceOf } from '../state/motion/balance.js';
import { placed, posesOf } from '../state/motion/body.js';
import { secondsText } from '../state/motion/timing.js';
import { MARK_KINDS } from './timeline.js';

/**
 * @typedef {import('./editor.js').Editor} Editor
 * @typedef {import('./orders.js').Order} Order
 */

const TOP = [['save', 'save-as', 'undo', 'redo'], ['duplicate', 'delete', 'copy', 'paste', 'earlier', 'later'], ['mirror', 'mirror-all', 'reverse', 'scale'], ['export']];

/**
 * @param {HTMLElement} place
 * @param {Editor} editor
 * @param {Order[]} orders
 * @returns {() => void} draws names and what is possible
 */
export function toolbar(place, editor, orders) {
  const title = element('strong', { class: 'file-name', id: 'file-name' });
  const buttons = new Map(orders.map((order) => [order.id, orderButton(order)]));
  const groups = TOP.map((ids) => element('div', { class: 'group' }, ...ids.map((id) => /** @type {HTMLElement} */ (buttons.get(id)))));
  place.append(title, ...groups);
  return () => {
    const { state } = editor;
    const frames = framesOf(state).length;
    setText(title, (state.name || 'new motion') + (isUnsaved(state) ? ' •' : ''));
    title.title = isUnsaved(state) ? 'Has unsaved changes; they are also kept as a draft' : 'Saved';
    const enable = (/** @type {string} */ id, /** @type {boolean} */ on) => {
      const found = buttons.get(id);
      if (found) {
        found.disabled = !on;
      }
    };
    const { past, present, future } = state.history;
    enable('undo', past.length > 0);
    enable('redo', future.length > 0);
    /** @type {HTMLElement} */ (buttons.get('undo')).title = past.length > 0 ? `Undo: ${present.label} (Ctrl Z)` : 'Nothing to undo';
    /** @type {HTMLElement} */ (buttons.get('redo')).title = future.length > 0 ? `Redo: ${future[0].label} (Ctrl Y)` : 'Nothing to redo';
    enable('paste', editor.clip.length > 0);
    for (const id of ['duplicate', 'delete', 'copy', 'mirror', 'mirror-all', 'reverse', 'scale', 'export', 'save', 'save-as']) {
      enable(id, frames > 0);
    }
    enable('earlier', Math.min(state.first, state.last) > 0);
    enable('later', Math.max(state.first, state.last) < frames - 1);
  };
}

/** @param {Order} order */
function orderButton({ id, name, hint, shown, act }) {
  const made = button(name, shown ? `${hint} (${shown})` : hint, act);
  made.id = id;
  return made;
}

/**
 * @param {HTMLElement} place
 * @param {Editor} editor
 * @param {Order[]} orders
 * @param {object} deeds
 * @param {(millis: number) => void} deeds.setTime of the chosen keyframe
 * @param {(start: string) => void} deeds.tryPhysically
 * @param {() => void} deeds.takePosture
 * @param {() => string} deeds.robotOfRun who gives the posture, empty if there is no robot
 * @returns {() => void}
 */
export function transportBar(place, editor, orders, deeds) {
  const byId = (/** @type {string} */ id) => /** @type {Order} */ (orders.find((order) => order.id === id));
  const play = orderButton(byId('play'));
  play.className = 'primary';
  const insert = orderButton(byId('insert'));
  const loop = element('input', { type: 'checkbox', id: 'loop' });
  loop.addEventListener('change', () => editor.apply((state) => ({ ...state, looping: loop.checked })));
  const speed = element('select', { id: 'animation-speed', 'aria-label': 'Speed of the animation' });
  speed.append(...[0.1, 0.25, 0.5, 1, 2].map((each) => element('option', { value: String(each) }, `${each}×`)));
  speed.addEventListener('change', () => editor.apply((state) => ({ ...state, speed: Number(speed.value) })));
  const millis = element('input', { type: 'text', inputmode: 'numeric', id: 'millis', 'aria-label': 'Time of the way to this keyframe in milliseconds' });
  millis.addEventListener('change', () => deeds.setTime(Number(millis.value)));
  const start = element('select', { id: 'trial-start', 'aria-label': 'How the robot is before the trial' });
  start.append(element('option', { value: 'standing' }, 'standing'), element('option', { value: 'back' }, 'on its back'), element('option', { value: 'front' }, 'on its front'));
  const trial = button('Try on a physical robot', 'A robot with weight, motors and ground plays the motion now', () => deeds.tryPhysically(start.value));
  trial.id = 'trial';
  const take = button('Take posture', '', deeds.takePosture);
  take.id = 'take-posture';
  const reading = element('span', { class: 'seconds' });
  const verdict = element('span', { class: 'verdict', role: 'status' });
  place.append(
    play,
    element('label', { class: 'check' }, loop, 'Loop'),
    speed,
    reading,
    element('label', { class: 'field', title: 'Time of the way from the keyframe before, in milliseconds' }, 'Way', millis, 'ms'),
    insert,
    take,
    verdict,
    element('div', { class: 'group trial' }, trial, start),
  );
  return () => {
    const { state } = editor;
    const frame = framesOf(state)[state.last];
    setText(play, state.playing ? '❚❚ Pause' : '▶ Play');
    setText(reading, `${secondsText(state.time)} of ${secondsText(lengthOf(state))}`);
    loop.checked = state.looping;
    speed.value = String(state.speed);
    if (document.activeElement !== millis) {
      millis.value = frame ? String(frame.millis) : '';
    }
    millis.disabled = !frame;
    trial.disabled = !frame || editor.busy;
    setText(trial, editor.busy ? 'Trying…' : 'Try on a physical robot');
    const robot = deeds.robotOfRun();
    take.disabled = robot === '';
    take.title = robot === '' ? 'Start an agent: the posture of its robot can then become a keyframe' : `The posture of ${robot} in the run becomes a keyframe`;
    setText(verdict, verdictText(editor));
    verdict.dataset.tone = editor.marks.length > 0 && !state.trial ? 'warning' : '';
  };
}

/** @param {Editor} editor */
function verdictText({ state, marks }) {
  if (state.trial) {
    return state.trial.fallSeconds === undefined ? 'Physical robot' : `Physical robot falls after ${secondsText(1000 * state.trial.fallSeconds)}`;
  }
  if (state.playing) {
    return '';
  }
  const here = marks.find(({ from, to, kind }) => kind !== 'balance' && state.time >= from - 1 && state.time <= to + 1);
  if (here) {
    return here.text;
  }
  const found = MARK_KINDS.map(({ kind, name }) => ({ name, count: marks.filter((mark) => mark.kind === kind).length })).filter(({ count }) => count > 0);
  const posture = postureNow(state);
  const { margin } = balanceOf(state.body, posesOf(state.body, posture, placed(state.body, posture, state.manner)));
  const balance = Number.isFinite(margin) ? `${margin >= 0 ? 'balanced by' : 'tips over by'} ${Math.abs(100 * margin).toFixed(1)} cm` : '';
  return [...found.map(({ name, count }) => `${name}: ${count}`), balance].filter(Boolean).join(' · ');
}
