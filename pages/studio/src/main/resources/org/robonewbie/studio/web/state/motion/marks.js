/**
 * Goes from mark to mark of the timeline. Pure.
 *
 * @typedef {import('./editor-state.js').EditorState} EditorState
 * @typedef {import('./checks.js').Mark} Mark
 */
import { atTime, framesOf, selected } from './editor-state.js';
import { revealing } from './time-view.js';
import { durationOf, timesOf } from './timing.js';

/**
 * @param {readonly Mark[]} marks
 * @param {number} time milliseconds
 * @returns {Mark | undefined} the first one after a moment, from the end the first of all
 */
export function nextMark(marks, time) {
  const sorted = [...marks].sort((a, b) => placeOf(a) - placeOf(b));
  return sorted.find((mark) => placeOf(mark) > time + 1) ?? sorted[0];
}

/**
 * Shows the place of a mark, and the curve of its joint.
 *
 * @param {EditorState} state
 * @param {Mark} mark
 * @returns {EditorState}
 */
export function atMark(state, mark) {
  const frames = framesOf(state);
  const time = placeOf(mark);
  const index = timesOf(frames).findIndex((each) => Math.abs(each - time) < 1);
  const there = index >= 0 ? selected(state, index) : atTime(state, time);
  const joint = mark.joint ?? state.joint;
  return { ...there, joint, rows: [], playing: false, view: revealing(state.view, durationOf(frames), time) };
}

/** @param {Mark} mark @returns {number} milliseconds: amid a way that is too fast, else where the trouble begins */
function placeOf({ kind, from, to }) {
  return kind === 'speed' ? (from + to) / 2 : from;
}
