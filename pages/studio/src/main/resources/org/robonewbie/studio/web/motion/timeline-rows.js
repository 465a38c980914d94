/** Dope sheet: one row per joint, with a diamond at each keyframe that changes its angle. */
import { diamond, shape } from '../panels/drawing.js';
import { framesOf } from '../state/motion/editor-state.js';
import { jointRows } from '../state/motion/names.js';
import { chosenFrames } from '../state/motion/selection.js';
import { timesOf } from '../state/motion/timing.js';

/**
 * @typedef {import('../state/motion/editor-state.js').EditorState} EditorState
 * @typedef {import('../state/motion/lag.js').Lag} Lag
 * @typedef {import('./timeline-scale.js').TimeScale} TimeScale
 */

export const ROW = 18;
const STILL_DEGREES = 0.05;

/**
 * @param {EditorState} state
 * @param {TimeScale} scale
 * @param {Lag | undefined} lag lag of the physical robot
 * @returns {SVGElement[]}
 */
export function drawRows(state, scale, lag) {
  const frames = framesOf(state);
  const xs = timesOf(frames).map((time) => scale.x(time));
  const chosen = new Set(chosenFrames(state));
  return jointRows(state.body).flatMap((joint, row) => {
    const y = row * ROW + ROW / 2;
    const isChosenRow = state.rows.length === 0 || state.rows.includes(joint);
    const angles = frames.map(({ degrees }) => degrees[joint]);
    const is = (/** @type {number} */ i) => chosen.has(i) && isChosenRow;
    const turns = angles.map((_, i) => turnsAt(angles, xs, i));
    /** @param {string} kind @param {(i: number) => boolean} isShown @param {number} size */
    const diamonds = (kind, isShown, size) =>
      shape('path', { class: kind, d: xs.map((x, i) => (isShown(i) ? diamond(x, y, size) : '')).join('') });
    return [
      shape('rect', { class: rowClass(state, joint), x: 0, y: row * ROW, width: '100%', height: ROW }),
      ...lagOf(lag, joint, y, scale),
      shape('path', { class: 'way', d: waysOf(angles, xs, y) }),
      diamonds('dot', (i) => !turns[i] && !is(i), 2),
      diamonds('key', (i) => turns[i] && !is(i), 4.5),
      diamonds('key chosen', is, 5),
    ];
  });
}

/** @param {EditorState} state @param {number} joint */
function rowClass(state, joint) {
  return state.rows.includes(joint) || state.joint === joint ? 'row chosen' : 'row';
}

/** Lines for the intervals in which the joint moves. @param {number[]} angles @param {number[]} xs @param {number} y */
function waysOf(angles, xs, y) {
  return angles
    .map((angle, i) => (i > 0 && angle !== angles[i - 1] ? `M${xs[i - 1].toFixed(1)} ${y}H${xs[i].toFixed(1)}` : ''))
    .join('');
}

/**
 * @param {number[]} angles
 * @param {number[]} xs
 * @param {number} i
 * @returns {boolean} whether the joint would move differently without this keyframe
 */
function turnsAt(angles, xs, i) {
  if (i === 0 || i === angles.length - 1) {
    return true;
  }
  const part = (xs[i] - xs[i - 1]) / Math.max(1e-6, xs[i + 1] - xs[i - 1]);
  return Math.abs(angles[i - 1] + part * (angles[i + 1] - angles[i - 1]) - angles[i]) > STILL_DEGREES;
}

/**
 * Segments in which the physical robot lags behind.
 *
 * @param {Lag | undefined} lag
 * @param {number} joint
 * @param {number} y
 * @param {TimeScale} scale
 */
function lagOf(lag, joint, y, scale) {
  const d = (lag?.late[joint] ?? [])
    .map(([from, to]) => `M${scale.x(from).toFixed(1)} ${y}H${scale.x(to).toFixed(1)}`)
    .join('');
  return d === '' ? [] : [shape('path', { class: 'late', d })];
}
