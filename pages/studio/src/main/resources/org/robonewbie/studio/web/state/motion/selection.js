/**
 * Selection in a motion: keyframes, and all or some of their joints. Pure.
 *
 * @typedef {import('./editor-state.js').EditorState} EditorState
 */
import { framesOf, selected } from './editor-state.js';
import { timesOf } from './timing.js';

/** @param {EditorState} state @returns {number[]} the selected keyframes in order */
export function chosenFrames(state) {
  const count = framesOf(state).length;
  return [...state.chosen].filter((index) => index < count).sort((a, b) => a - b);
}

/**
 * @param {EditorState} state
 * @returns {readonly number[]} the joints that edits change: the selected rows, or the joint whose curve is shown
 */
export function chosenJoints(state) {
  return state.rows.length > 0 ? state.rows : [state.joint];
}

/**
 * Adds a keyframe to the selection or removes it, unless it is the only one selected.
 *
 * @param {EditorState} state
 * @param {number} index
 * @returns {EditorState}
 */
export function toggled(state, index) {
  const without = state.chosen.filter((each) => each !== index);
  if (without.length === state.chosen.length) {
    return { ...selected(state, index), chosen: [...without, index] };
  }
  return without.length === 0 ? state : { ...selected(state, without[without.length - 1]), chosen: without };
}

/**
 * Selects a joint and shows its curve.
 *
 * @param {EditorState} state
 * @param {number} joint
 * @param {'only' | 'toggle'} [manner]
 * @returns {EditorState}
 */
export function withRow(state, joint, manner = 'only') {
  if (manner === 'only') {
    return { ...state, joint, rows: [joint] };
  }
  const without = state.rows.filter((each) => each !== joint);
  const rows = without.length < state.rows.length ? without : [...state.rows, joint];
  return { ...state, joint: rows.at(-1) ?? joint, rows };
}

/** @param {EditorState} state @returns {EditorState} state in which all joints of the selected keyframes are selected */
export function withoutRows(state) {
  return { ...state, rows: [] };
}

/** @param {EditorState} state @returns {EditorState} */
export function withAllChosen(state) {
  const frames = framesOf(state);
  return { ...state, first: 0, chosen: frames.map((_, index) => index) };
}

/**
 * @param {EditorState} state @returns {EditorState} state in which only the keyframe at the playhead is selected, with all of its joints
 */
export function withOneChosen(state) {
  return { ...state, first: state.last, chosen: [state.last], rows: [] };
}

/**
 * @typedef {object} Box selection box of the timeline
 * @property {number} from milliseconds
 * @property {number} to milliseconds
 * @property {readonly number[]} [rows] joints that it covers; if omitted, those already selected
 * @property {number} [low] lower limit in degrees, for a box around points of curves
 * @property {number} [high] upper limit in degrees
 */

/**
 * Selects the content of a box.
 *
 * @param {EditorState} state
 * @param {Box} box
 * @param {boolean} [adding] whether to add to the selection
 * @returns {EditorState} the new state; unchanged if no keyframe is in the box
 */
export function boxed(state, { from, to, rows, low = -Infinity, high = Infinity }, adding = false) {
  const frames = framesOf(state);
  const joints = chosenJoints(state);
  const isInside = (/** @type {number} */ time, /** @type {number} */ i) =>
    time >= from && time <= to && joints.some((joint) => betweenAngles(frames[i].degrees[joint], low, high));
  const inside = timesOf(frames).flatMap((time, i) => (isInside(time, i) ? [i] : []));
  if (inside.length === 0 || rows?.length === 0) {
    return state;
  }
  const chosen = [...new Set([...(adding ? state.chosen : []), ...inside])];
  const all = rows ? [...new Set([...(adding ? state.rows : []), ...rows])] : state.rows;
  return {
    ...selected(state, inside[inside.length - 1]),
    first: inside[0],
    chosen,
    rows: all,
    joint: all[0] ?? state.joint,
  };
}

/** @param {number} degrees @param {number} low @param {number} high */
function betweenAngles(degrees, low, high) {
  return degrees >= low && degrees <= high;
}
