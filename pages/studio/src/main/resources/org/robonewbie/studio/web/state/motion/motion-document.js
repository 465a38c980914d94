/**
 * Edits of motion documents: each function takes a document and returns a new one; unaffected lines stay unchanged. Pure.
 *
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./motion-text.js').Line} Line
 * @typedef {import('./motion-text.js').MotionDocument} MotionDocument
 */
import { changedLine, newLine } from './motion-text.js';

/** Duration of a cycle; a robot plays motions in whole cycles. */
export const CYCLE_MILLIS = 20;

/** Longest duration of a keyframe: ten minutes. */
export const MAX_MILLIS = 600_000;

/**
 * @param {MotionDocument} document
 * @returns {Keyframe[]}
 */
export function keyframesOf(document) {
  return document.lines.flatMap(({ keyframe }) => (keyframe ? [keyframe] : []));
}

/**
 * @param {MotionDocument} document
 * @param {number} index
 * @param {Partial<Keyframe>} change
 * @returns {MotionDocument}
 */
export function withKeyframe(document, index, change) {
  const at = lineOf(document, index);
  const line = document.lines[at];
  const keyframe = { .../** @type {Keyframe} */ (line.keyframe), ...change };
  return withLines(document, document.lines.with(at, changedLine(line, keyframe)));
}

/**
 * @param {MotionDocument} document
 * @param {number} index index of the new keyframe
 * @param {Keyframe} keyframe
 * @returns {MotionDocument}
 */
export function withInserted(document, index, keyframe) {
  return insertLine(document, index, newLine(keyframe, lineEndOf(document)));
}

/**
 * @param {MotionDocument} document
 * @param {number} index
 * @returns {MotionDocument}
 */
export function without(document, index) {
  return withLines(document, document.lines.toSpliced(lineOf(document, index), 1));
}

/**
 * Moves a keyframe with its comment to another position.
 *
 * @param {MotionDocument} document
 * @param {number} from
 * @param {number} to index afterwards
 * @returns {MotionDocument}
 */
export function withMoved(document, from, to) {
  const line = document.lines[lineOf(document, from)];
  const moved = line.end === '' ? { ...line, end: lineEndOf(document) } : line;
  return insertLine(without(document, from), to, moved);
}

/**
 * Reverses the order of the postures; each transition keeps its duration, and the first keyframe keeps its time.
 *
 * @param {MotionDocument} document
 * @returns {MotionDocument}
 */
export function reversed(document) {
  const frames = keyframesOf(document);
  const { length } = frames;
  return mapKeyframes(document, (_, i) => ({
    millis: frames[(length - i) % length].millis,
    degrees: frames[length - 1 - i].degrees,
  }));
}

/**
 * @param {MotionDocument} document
 * @param {number} factor factor for all durations; above 1 is slower
 * @returns {MotionDocument}
 */
export function scaled(document, factor) {
  return mapKeyframes(document, ({ millis, degrees }) => ({ millis: wholeCycles(millis * factor), degrees }));
}

/**
 * @param {MotionDocument} document
 * @param {(keyframe: Keyframe, index: number) => Keyframe} change
 * @returns {MotionDocument}
 */
export function mapKeyframes(document, change) {
  let index = 0;
  return withLines(
    document,
    document.lines.map((line) => (line.keyframe ? changedLine(line, change(line.keyframe, index++)) : line)),
  );
}

/** @param {number} millis @returns {number} the nearest whole number of cycles in milliseconds, from one cycle to ten minutes */
export function wholeCycles(millis) {
  return Math.max(1, Math.round(Math.min(MAX_MILLIS, millis) / CYCLE_MILLIS)) * CYCLE_MILLIS;
}

/** @param {MotionDocument} document @param {readonly Line[]} lines */
function withLines(document, lines) {
  return { ...document, lines };
}

/**
 * @param {MotionDocument} document
 * @param {number} index
 */
function lineOf(document, index) {
  let seen = -1;
  const at = document.lines.findIndex(({ keyframe }) => keyframe !== undefined && ++seen === index);
  if (at < 0) {
    throw new RangeError(`The motion has no keyframe ${index + 1}.`);
  }
  return at;
}

/**
 * @param {MotionDocument} document
 * @param {number} index
 * @param {Line} line
 */
function insertLine(document, index, line) {
  const count = keyframesOf(document).length;
  if (index < count) {
    return withLines(document, document.lines.toSpliced(lineOf(document, index), 0, line));
  }
  const at = count === 0 ? document.lines.length : lineOf(document, count - 1) + 1;
  const before = document.lines
    .slice(0, at)
    .map((each, i) => (i === at - 1 && each.end === '' ? { ...each, end: line.end } : each));
  return withLines(document, [...before, line, ...document.lines.slice(at)]);
}

/** @param {MotionDocument} document */
function lineEndOf(document) {
  return document.lines.find(({ end }) => end !== '')?.end ?? '\n';
}
