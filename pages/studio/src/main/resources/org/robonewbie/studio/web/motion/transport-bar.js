/** Playback controls of a motion: play, time, and a trial on a physically simulated robot. */
import { button, check, choice, element, setText } from '../panels/elements.js';
import { balanceOf } from '../state/motion/balance.js';
import { placed, posesOf } from '../state/motion/body.js';
import { documentOf, framesOf, lengthOf, postureNow } from '../state/motion/editor-state.js';
import { jointName } from '../state/motion/names.js';
import { MAX_MILLIS } from '../state/motion/motion-document.js';
import { problemOf } from '../state/motion/motion-text.js';
import { secondsText } from '../state/motion/timing.js';
import { numberField, showNumber } from './number-field.js';
import { MARK_KINDS } from './timeline-head.js';
import { orderButton } from './toolbar.js';

/**
 * @typedef {import('./editor.js').Editor} Editor
 * @typedef {import('./orders.js').Order} Order
 *
 * @typedef {object} Actions
 * @property {(millis: number) => void} setTime sets the time of the selected keyframe
 * @property {(start: string) => void} tryPhysically
 * @property {(text: string) => void} note
 */

const SPEEDS = [0.1, 0.25, 0.5, 1, 2];
const TRIAL = 'Try with physics';
const TRIAL_HINT = 'Plays the motion on a simulated robot with mass and motors';

const VERDICT_HINT = 'What can go wrong on a robot. The centre of mass must be above the feet, or the robot tips over.';

/** @type {Array<[value: string, text: string]>} */
const STARTS = [
  ['standing', 'standing'],
  ['back', 'on its back'],
  ['front', 'on its front'],
];

/**
 * @param {HTMLElement} place
 * @param {Editor} editor
 * @param {Order[]} orders
 * @param {Actions} actions
 * @returns {() => void}
 */
export function transportBar(place, editor, orders, actions) {
  const parts = partsOf(editor, orders, actions);
  const { play, loop, speed, reading, millis, insert, verdict, trial, start } = parts;
  place.append(
    ...[play, loop.label, speed, reading, timeField(millis), insert, verdict],
    element('div', { class: 'group trial' }, trial, start),
  );
  return () => {
    trial.hidden = start.hidden = !editor.state.body.isNao;
    drawPlaying(parts, editor);
    drawTrial(parts, editor);
  };
}

/** @param {Editor} editor @param {Order[]} orders @param {Actions} actions */
function partsOf(editor, orders, actions) {
  const byId = (/** @type {string} */ id) => /** @type {Order} */ (orders.find((order) => order.id === id));
  const play = orderButton(byId('play'));
  play.className = 'primary';
  const start = choice({ id: 'trial-start', 'aria-label': 'Position of the robot before the trial' }, STARTS, () => {});
  return {
    play,
    insert: orderButton(byId('insert')),
    loop: check('loop', 'Loop', '', (looping) => editor.apply((state) => ({ ...state, looping }))),
    speed: choice(
      { id: 'animation-speed', 'aria-label': 'Animation speed' },
      SPEEDS.map((each) => [String(each), `${each}×`]),
      (speed) => editor.apply((state) => ({ ...state, speed: Number(speed) })),
    ),
    millis: millisField(actions),
    start,
    trial: button(TRIAL, TRIAL_HINT, () => actions.tryPhysically(start.value), { id: 'trial' }),
    reading: element('span', { class: 'seconds' }),
    verdict: element('span', { class: 'verdict', role: 'status' }),
  };
}

/** @param {Actions} actions */
function millisField({ setTime, note }) {
  const label = 'Time to reach this keyframe in milliseconds';
  return numberField({ inputmode: 'numeric', id: 'millis', 'aria-label': label }, MAX_MILLIS, setTime, (text) =>
    note(`“${text}” is not a time in milliseconds, at most ${MAX_MILLIS}; the keyframe was not moved.`),
  );
}

/** @param {HTMLInputElement} millis */
function timeField(millis) {
  const title = 'Time from the previous keyframe';
  const name = element('span', {}, 'Time', element('span', { class: 'if-wide' }, ' to get there'));
  return element('label', { class: 'field', title }, name, millis, 'ms');
}

/** @typedef {ReturnType<typeof partsOf>} Parts */

/** @param {Parts} parts @param {Editor} editor */
function drawPlaying({ play, reading, loop, speed, millis }, { state }) {
  const frame = framesOf(state)[state.last];
  setText(play, state.playing ? '❚❚ Pause' : '▶ Play');
  setText(reading, `${secondsText(state.time)} of ${secondsText(lengthOf(state))}`);
  loop.box.checked = state.looping;
  speed.value = String(state.speed);
  showNumber(millis, frame ? String(frame.millis) : '');
  millis.disabled = !frame;
}

/** @param {Parts} parts @param {Editor} editor */
function drawTrial({ trial, verdict }, editor) {
  const { state, marks, busy } = editor;
  trial.disabled = framesOf(state).length === 0 || busy;
  setText(trial, busy ? 'Trying…' : TRIAL);
  const text = verdictText(editor);
  setText(verdict, text);
  verdict.title = text ? `${text}\n${VERDICT_HINT}` : VERDICT_HINT;
  verdict.dataset.tone = (marks.length > 0 || problemOf(documentOf(state)) !== '') && !state.watching ? 'warning' : '';
}

/** @param {Editor} editor */
function verdictText({ state, marks }) {
  if (state.trial && state.watching) {
    return state.trial.fallSeconds === undefined
      ? 'Trial with physics'
      : `With physics, the robot falls after ${secondsText(1000 * state.trial.fallSeconds)}`;
  }
  if (state.playing) {
    return '';
  }
  const problem = problemOf(documentOf(state));
  if (problem) {
    return `${problem}. Agents reject this file.`;
  }
  const here = marks.find(({ from, to }) => state.time >= from - 1 && state.time <= to + 1);
  if (here) {
    return [chosenText(state), here.text].filter(Boolean).join(' · ');
  }
  const found = MARK_KINDS.map(({ kind, name }) => ({
    name,
    count: marks.filter((mark) => mark.kind === kind).length,
  })).filter(({ count }) => count > 0);
  const counts = found.map(({ name, count }) => `${name}: ${count}`);
  return [chosenText(state), ...counts, balanceText(state)].filter(Boolean).join(' · ');
}

/** Describes the selection, unless it is just the keyframe at the playhead. @param {Editor['state']} state */
function chosenText(state) {
  const { chosen, rows, body } = state;
  const frames = chosen.length === 1 ? `keyframe ${chosen[0] + 1}` : `${chosen.length} keyframes`;
  if (rows.length === 1) {
    return `${jointName(body.joints[rows[0]].name)} in ${frames} selected`;
  }
  const joints = rows.length === 0 ? '' : `${rows.length} joints in `;
  return rows.length === 0 && chosen.length === 1 ? '' : `${joints}${frames} selected`;
}

/** @param {Editor['state']} state */
function balanceText(state) {
  const posture = postureNow(state);
  const { margin } = balanceOf(state.body, posesOf(state.body, posture, placed(state.body, posture, state.manner)));
  return Number.isFinite(margin)
    ? `${Math.abs(100 * margin).toFixed(1)} cm ${margin >= 0 ? 'inside' : 'outside'} the feet`
    : '';
}
