/**
 * Detects motions written for RoboNewbie 1.1, which skipped keyframes shorter than two cycles. Pure.
 *
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./motion-text.js').MotionDocument} MotionDocument
 */
import { keyframesOf } from './motion-document.js';
import { parse } from './motion-text.js';

const TWO_CYCLES = 40;
const ORIGINAL = '// play: 1.1';

/** Header comments, found only in motion files newer than RoboNewbie 1.1. */
const DESCRIBED = /^\s*\/\/\s*(play|columns|measured|does|start|end|ball|made by)\s*:/i;

/** @param {MotionDocument} document @returns {boolean} whether it has no header comments, like the files of RoboNewbie 1.1 */
export function isUndescribed({ lines }) {
  return !lines.some(({ text }) => DESCRIBED.test(text));
}

/**
 * Returns whether a motion mixes keyframes that RoboNewbie 1.1 skipped with others. A motion that has only short transitions is a
 * recording; under that rule, the robot would not move at all.
 *
 * @param {MotionDocument} document
 * @returns {boolean}
 */
export function hasSkippedKeyframes(document) {
  const frames = keyframesOf(document);
  const short = frames.filter(({ millis }) => millis > 0 && millis < TWO_CYCLES);
  const isOther = (/** @type {Keyframe} */ frame) => {
    const before = frames[frames.indexOf(frame) - 1];
    return before !== undefined && frame.degrees.some((angle, joint) => angle !== before.degrees[joint]);
  };
  return short.some(isOther) && 2 * short.length <= frames.length;
}

/** @param {MotionDocument} document @returns {MotionDocument} the document, marked for playback under the rule of RoboNewbie 1.1 */
export function asOriginal(document) {
  const end = document.lines.find((line) => line.end !== '')?.end ?? '\n';
  return { ...document, lines: [...parse(ORIGINAL + end).lines, ...document.lines] };
}
