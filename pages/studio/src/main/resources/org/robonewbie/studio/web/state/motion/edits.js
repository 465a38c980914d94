/**
 * Edits of the motion editor: each takes the editor's state and returns the next one. Pure.
 *
 * @typedef {import('./editor-state.js').EditorState} EditorState
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./motion-text.js').MotionDocument} MotionDocument
 *
 * @typedef {object} Clip clipboard content
 * @property {readonly Keyframe[]} frames
 * @property {readonly number[]} rows joints whose angles were copied, empty for whole keyframes
 */
import { fourDecimals } from '../numbers.js';
import { documentOf, edited, framesOf, posed, postureNow, selected, selectionOf } from './editor-state.js';
import {
  keyframesOf,
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
import { retimed } from './retime.js';
import { chosenFrames } from './selection.js';
import { timesOf } from './timing.js';

/** @param {EditorState} state @returns {Clip} the selected keyframes */
export function copied(state) {
  const frames = framesOf(state);
  return { frames: chosenFrames(state).map((index) => frames[index]), rows: state.rows };
}

/**
 * Inserts keyframes after the selected ones; if only some joints were copied, overwrites their angles from the selected keyframe on.
 *
 * @param {EditorState} state
 * @param {Clip} clip
 * @returns {EditorState}
 */
export function pasted(state, { frames, rows }) {
  if (rows.length === 0) {
    return insertedAfter(state, frames, `Paste ${countText(frames.length)}`);
  }
  const [from] = selectionOf(state);
  const document = mapKeyframes(documentOf(state), (frame, i) => {
    const source = frames[i - from];
    return source ? { ...frame, degrees: withJoints(frame.degrees, rows, (joint) => source.degrees[joint]) } : frame;
  });
  return edited(state, document, `Paste angles of ${jointsText(rows.length)}`);
}

/** @param {EditorState} state @returns {EditorState} */
export function duplicated(state) {
  return insertedAfter(state, copied(state).frames, 'Duplicate');
}

/**
 * @param {EditorState} state @returns {EditorState} state without the selected keyframes, or without their angles of the selected joints
 */
export function deleted(state) {
  return state.rows.length > 0 ? straightened(state) : withoutChosen(state);
}

/** @param {EditorState} state */
function withoutChosen(state) {
  const chosen = chosenFrames(state);
  const document = chosen.toReversed().reduce((each, index) => without(each, index), documentOf(state));
  return chosen.length < 1
    ? state
    : selected(edited(state, document, `Delete ${countText(chosen.length)}`), Math.max(0, chosen[0] - 1));
}

/** Interpolates the selected joints between the keyframe before the selection and the one after. @param {EditorState} state */
function straightened(state) {
  const frames = framesOf(state);
  const times = timesOf(frames);
  const chosen = chosenFrames(state);
  const others = frames.map((_, index) => index).filter((index) => !chosen.includes(index));
  const document = mapKeyframes(documentOf(state), (frame, i) => {
    const before = others.findLast((index) => index < i) ?? others.find((index) => index > i);
    const after = others.find((index) => index > i) ?? before;
    if (!chosen.includes(i) || before === undefined || after === undefined) {
      return frame;
    }
    const part = after === before ? 0 : (times[i] - times[before]) / Math.max(1, times[after] - times[before]);
    const between = (/** @type {number} */ joint) =>
      fourDecimals(
        frames[before].degrees[joint] + part * (frames[after].degrees[joint] - frames[before].degrees[joint]),
      );
    return { ...frame, degrees: withJoints(frame.degrees, state.rows, between) };
  });
  return edited(state, document, `Remove angles of ${jointsText(state.rows.length)}`);
}

/**
 * Moves the selected keyframes in time.
 *
 * @param {EditorState} state
 * @param {number} by milliseconds, negative for earlier
 * @param {{alone?: boolean, base?: MotionDocument, gesture?: string}} [how] `alone`: whether later keyframes stay in place; `base` and
 *     `gesture`: for a drag, the motion before it and the name of the gesture
 * @returns {EditorState}
 */
export function moved(state, by, { alone = state.alone, base = documentOf(state), gesture = '' } = {}) {
  const ways = keyframesOf(base).map(({ millis }) => millis);
  const next = retimed(ways, chosenFrames(state), by, alone);
  const document = mapKeyframes(base, ({ degrees }, i) => ({ millis: next[i], degrees }));
  const done = edited(state, document, 'Move in time', gesture);
  return { ...done, time: timesOf(framesOf(done))[done.last] ?? 0 };
}

/**
 * Turns joints by the same amount in all selected keyframes, as far as all joint ranges allow.
 *
 * @param {EditorState} state
 * @param {readonly number[]} joints
 * @param {number} by degrees
 * @param {{base?: MotionDocument, gesture?: string}} [how] for a drag, the motion before it and the name of the gesture
 * @returns {EditorState}
 */
export function turnedBy(state, joints, by, { base = documentOf(state), gesture = '' } = {}) {
  const { body } = state;
  const chosen = chosenFrames(state);
  const frames = keyframesOf(base);
  const turns = withPartners(state, joints);
  const rooms = chosen.flatMap((index) =>
    [...turns].map(([joint, sign]) => {
      const { minDegrees, maxDegrees } = body.joints[joint];
      const angle = frames[index].degrees[joint];
      return sign * by > 0 ? maxDegrees - angle : angle - minDegrees;
    }),
  );
  const amount = Math.sign(by) * Math.max(0, Math.min(Math.abs(by), ...rooms));
  const document = mapKeyframes(base, (frame, i) =>
    chosen.includes(i)
      ? {
          ...frame,
          degrees: withJoints(frame.degrees, [...turns.keys()], (joint) =>
            fourDecimals(frame.degrees[joint] + (turns.get(joint) ?? 1) * amount),
          ),
        }
      : frame,
  );
  return edited(state, document, `Turn ${jointsText(turns.size)}`, gesture);
}

/** @param {EditorState} state @param {readonly number[]} joints @returns {Map<number, number>} sign of the rotation by joint */
function withPartners({ body, symmetric }, joints) {
  const turns = new Map(joints.map((joint) => [joint, 1]));
  for (const joint of symmetric ? joints : []) {
    const { partner, mirrorSign } = body.joints[joint];
    turns.set(partner, turns.get(partner) ?? mirrorSign);
  }
  return turns;
}

/** @param {readonly number[]} degrees @param {readonly number[]} joints @param {(joint: number) => number} angleOf */
function withJoints(degrees, joints, angleOf) {
  return degrees.map((angle, joint) => (joints.includes(joint) ? angleOf(joint) : angle));
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
  const ordered = selected(edited(state, document, 'Move'), from + direction);
  return selected(ordered, to + direction, true);
}

/** @param {EditorState} state @param {number} index @param {number} millis @param {string} [gesture] @returns {EditorState} */
export function timed(state, index, millis, gesture = '') {
  const document = withKeyframe(documentOf(state), index, { millis: wholeCycles(millis) });
  return selected(edited(state, document, 'Change time', gesture), index);
}

/** @param {EditorState} state @returns {EditorState} state with left and right swapped in the selected keyframes */
export function mirroredSelection(state) {
  const chosen = chosenFrames(state);
  const document = mapKeyframes(documentOf(state), (frame, i) =>
    chosen.includes(i) ? { ...frame, degrees: mirrored(state.body, frame.degrees) } : frame,
  );
  return edited(state, document, 'Mirror');
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

/** @param {EditorState} state @param {number} factor factor for all durations; above 1 is slower @returns {EditorState} */
export function scaledMotion(state, factor) {
  const label = factor > 1 ? 'Slower' : 'Faster';
  return selected(edited(state, scaled(documentOf(state), factor), label), state.last);
}

/** @param {EditorState} state @param {'LEFT' | 'RIGHT'} side source side @returns {EditorState} */
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
function jointsText(count) {
  return count === 1 ? 'a joint' : `${count} joints`;
}

/** @param {number} count */
function countText(count) {
  return count === 1 ? 'keyframe' : `${count} keyframes`;
}
