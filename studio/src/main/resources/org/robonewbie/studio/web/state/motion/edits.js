/**
 * What the buttons and keys of the motion editor do: each edit takes the editor's state and gives the next one. Pure.
 *
 * @typedef {import('./editor-state.js').EditorState} EditorState
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 */
import { documentOf, edited, framesOf, posed, postureNow, selected, selectionOf } from './editor-state.js';
import {
  mapKeyframes,
  reversed,
  scaled,
  wholeCycles,
  withInserted,
  withKeyframe,
  withMoved,
  without,
} from './motion-document.js';
import { copiedSide, mirrored } from './posture.js';

/** @param {EditorState} state @returns {Keyframe[]} the chosen keyframes */
export function copied(state) {
  const [from, to] = selectionOf(state);
  return framesOf(state).slice(from, to + 1);
}

/** @param {EditorState} state @param {readonly Keyframe[]} frames @returns {EditorState} */
export function pasted(state, frames) {
  return insertedAfter(state, frames, `Paste ${countText(frames.length)}`);
}

/** @param {EditorState} state @returns {EditorState} */
export function duplicated(state) {
  return insertedAfter(state, copied(state), 'Duplicate');
}

/** @param {EditorState} state @returns {EditorState} */
export function deleted(state) {
  const [from, to] = selectionOf(state);
  const count = Math.min(to, framesOf(state).length - 1) - from + 1;
  let document = documentOf(state);
  for (let i = 0; i < count; i++) {
    document = without(document, from);
  }
  return count < 1 ? state : selected(edited(state, document, `Delete ${countText(count)}`), Math.max(0, from - 1));
}

/** @param {EditorState} state @param {-1 | 1} direction @returns {EditorState} */
export function shifted(state, direction) {
  const [from, to] = selectionOf(state);
  const target = direction < 0 ? from - 1 : to + 1;
  if (target < 0 || target >= framesOf(state).length) {
    return state;
  }
  const document =
    direction < 0 ? withMoved(documentOf(state), target, to) : withMoved(documentOf(state), target, from);
  const moved = selected(edited(state, document, 'Move'), from + direction);
  return selected(moved, to + direction, true);
}

/** @param {EditorState} state @param {number} index @param {number} millis @param {string} [gesture] @returns {EditorState} */
export function timed(state, index, millis, gesture = '') {
  const document = withKeyframe(documentOf(state), index, { millis: wholeCycles(millis) });
  return selected(edited(state, document, 'Change time', gesture), index);
}

/** @param {EditorState} state @returns {EditorState} left and right of the chosen keyframes exchanged */
export function mirroredSelection(state) {
  return mappedSelection(state, 'Mirror', (degrees) => mirrored(state.body, degrees));
}

/** @param {EditorState} state @returns {EditorState} */
export function mirroredMotion(state) {
  const document = mapKeyframes(documentOf(state), ({ millis, degrees }) => ({
    millis,
    degrees: mirrored(state.body, degrees),
  }));
  return selected(edited(state, document, 'Mirror the motion'), state.last);
}

/** @param {EditorState} state @returns {EditorState} */
export function reversedMotion(state) {
  return selected(edited(state, reversed(documentOf(state)), 'Reverse the motion'), 0);
}

/** @param {EditorState} state @param {number} factor above 1 is slower @returns {EditorState} */
export function scaledMotion(state, factor) {
  const label = factor > 1 ? 'Slower' : 'Faster';
  return selected(edited(state, scaled(documentOf(state), factor), label), state.last);
}

/** @param {EditorState} state @param {'LEFT' | 'RIGHT'} side that stays @returns {EditorState} */
export function sideCopied(state, side) {
  const posture = copiedSide(state.body, postureNow(state), side);
  return posed({ ...state, symmetric: false }, posture, `Copy the ${side.toLowerCase()} side`);
}

/**
 * @param {EditorState} state
 * @param {number} joint
 * @param {number} degrees
 * @param {string} [gesture]
 * @returns {EditorState}
 */
export function turned(state, joint, degrees, gesture = '') {
  const before = postureNow(state);
  const next = posed(state, before.with(joint, degrees), 'Turn a joint', gesture);
  return { ...next, symmetric: state.symmetric, joint };
}

/**
 * @param {EditorState} state
 * @param {string} label
 * @param {(degrees: readonly number[]) => number[]} change
 */
function mappedSelection(state, label, change) {
  const [from, to] = selectionOf(state);
  const document = mapKeyframes(documentOf(state), (frame, i) =>
    i >= from && i <= to ? { millis: frame.millis, degrees: change(frame.degrees) } : frame,
  );
  return edited(state, document, label);
}

/** @param {EditorState} state @param {readonly Keyframe[]} frames @param {string} label */
function insertedAfter(state, frames, label) {
  const [, to] = selectionOf(state);
  const at = framesOf(state).length === 0 ? 0 : to + 1;
  const document = frames.reduce((each, frame, i) => withInserted(each, at + i, frame), documentOf(state));
  return frames.length === 0
    ? state
    : selected(selected(edited(state, document, label), at), at + frames.length - 1, true);
}

/** @param {number} count */
function countText(count) {
  return count === 1 ? 'keyframe' : `${count} keyframes`;
}
