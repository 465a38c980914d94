/**
 * Moves from mark to mark on the timeline. Pure.
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
 * @returns {Mark | undefined} the next mark after a time, wrapping around at the end
 */
export function nextMark(marks, time) {
  const sorted = [...marks].sort((a, b) => placeOf(a) - placeOf(b));
  return sorted.find((mark) => placeOf(mark) > time + 1) ?? sorted[0];
}

/**
 * Moves the playhead to a mark and shows the curve of its joint.
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

/** @param {Mark} mark @returns {number} milliseconds: the middle of a transition that is too fast, otherwise the start of the mark */
function placeOf({ kind, from, to }) {
  return kind === 'speed' ? (from + to) / 2 : from;
}
