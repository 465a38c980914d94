/**
 * Lossless parser and writer of motion files: every line keeps its characters, comments, digits and line ending until it is edited. The
 * rules are those of the Java class MotionFile. Pure.
 *
 * @typedef {object} Keyframe
 * @property {number} millis duration of the transition to this posture
 * @property {readonly number[]} degrees one angle for each joint, in the order of the file
 *
 * @typedef {object} Line
 * @property {string} text
 * @property {string} end the original line ending, or empty
 * @property {Keyframe} [keyframe] keyframe of the line
 * @property {string} [problem] error in the line
 *
 * @typedef {import('../decoded-text.js').Source & {lines: readonly Line[]}} MotionDocument
 */
import { decodeText, encodeText, UTF_8 } from '../decoded-text.js';

/** Number of joints of the NAO, for which a motion is unless its file names another robot. */
export const JOINT_COUNT = 22;

/** The robot of a motion whose file names none. */
export const NAO = 'NAO';

const INTEGER = /^[+-]?\d{1,9}$/;
const DECIMAL = /^[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?$/;
const MARK = '\uFEFF';

/** An empty document. @type {MotionDocument} */
export const EMPTY_DOCUMENT = { ...UTF_8, lines: [] };

/**
 * @param {Uint8Array} bytes content of a file
 * @param {number} [joints] number of joints of its robot
 * @returns {MotionDocument}
 * @throws {import('../decoded-text.js').UndecodableText} if the bytes are not text
 */
export function decode(bytes, joints) {
  const { encoding, hasByteOrderMark, content } = decodeText(bytes);
  return { encoding, hasByteOrderMark, lines: linesOf(content, joints) };
}

/**
 * @param {MotionDocument} document
 * @returns {Uint8Array<ArrayBuffer>} the bytes of the file
 */
export function encode(document) {
  return encodeText(document, contentOf(document));
}

/**
 * @param {string} text
 * @returns {MotionDocument}
 */
export function parse(text) {
  const hasByteOrderMark = text.startsWith(MARK);
  return { encoding: 'UTF-8', hasByteOrderMark, lines: linesOf(hasByteOrderMark ? text.slice(1) : text) };
}

/** @param {string} content @param {number} [joints] @returns {Line[]} */
function linesOf(content, joints) {
  return Array.from(content.matchAll(/([^\r\n]*)(\r\n|\r|\n|$)/g))
    .filter(([whole]) => whole !== '')
    .map(([, text, end]) => parseLine(text, end, joints));
}

/** @param {MotionDocument} document @returns {string} the text without a byte order mark */
export function contentOf({ lines }) {
  return lines.map(({ text, end }) => text + end).join('');
}

/** @param {MotionDocument} document */
export function textOf(document) {
  return (document.hasByteOrderMark ? MARK : '') + contentOf(document);
}

/**
 * @param {string} text
 * @param {string} end
 * @param {number} [joints] number of joints of the robot
 * @returns {Line}
 */
export function parseLine(text, end, joints = JOINT_COUNT) {
  const words = wordsOf(text);
  if (words.length === 0) {
    return { text, end };
  }
  const wrong = words.findIndex(({ word }, i) => !(i === 0 ? INTEGER.test(word) : isDecimal(word)));
  if (wrong === 0) {
    return { text, end, problem: `found “${words[0].word}”, expected the time in whole milliseconds, such as 500` };
  }
  if (wrong > 0) {
    return { text, end, problem: `found “${words[wrong].word}”, expected an angle in degrees, such as -12.5` };
  }
  if (words.length !== 1 + joints) {
    return { text, end, problem: `${words.length - 1} angles, expected ${joints}, one for each joint` };
  }
  const [millis, ...degrees] = words.map(({ word }) => Number(word) + 0);
  return { text, end, keyframe: { millis, degrees } };
}

/**
 * Returns the robot that a motion is for: the value of the comment `// robot:`.
 *
 * @param {MotionDocument} document
 * @returns {string}
 */
export function robotOf({ lines }) {
  const comments = lines.filter(({ keyframe, problem }) => !keyframe && !problem);
  const values = comments.flatMap(({ text }) => /^\s*\/\/\s*robot:(.*)$/s.exec(text)?.[1].trim() ?? []);
  return values[0] ?? NAO;
}

/** @param {string} robot @returns {MotionDocument} a document without keyframes */
export function emptyDocument(robot) {
  return robot === NAO ? EMPTY_DOCUMENT : { ...EMPTY_DOCUMENT, lines: [{ text: `// robot: ${robot}`, end: '\n' }] };
}

/**
 * Formats a keyframe as a new line.
 *
 * @param {Keyframe} keyframe
 * @param {string} end
 * @returns {Line}
 */
export function newLine(keyframe, end) {
  return { text: [keyframe.millis, ...keyframe.degrees].map(numberText).join(' '), end, keyframe };
}

/**
 * Replaces the numbers of a line; unchanged numbers keep their digits, and blanks and comments are kept.
 *
 * @param {Line} line line with a keyframe
 * @param {Keyframe} keyframe
 * @returns {Line}
 */
export function changedLine(line, keyframe) {
  const before = /** @type {Keyframe} */ (line.keyframe);
  const [old, wanted] = [before, keyframe].map(({ millis, degrees }) => [millis, ...degrees]);
  let text = '';
  let copied = 0;
  wordsOf(line.text).forEach(({ word, at }, i) => {
    text += line.text.slice(copied, at) + (old[i] === wanted[i] ? word : numberText(wanted[i]));
    copied = at + word.length;
  });
  return { text: text + line.text.slice(copied), end: line.end, keyframe };
}

/**
 * @param {number} value
 * @returns {string} decimal notation without exponent
 */
export function numberText(value) {
  const text = String(value === 0 ? 0 : value);
  return text.includes('e') ? value.toFixed(20).replace(/\.?0+$/, '') : text;
}

/** @param {string} word */
function isDecimal(word) {
  return DECIMAL.test(word) && Number.isFinite(Number(word));
}

/**
 * Returns the words of a line before its comment.
 *
 * @param {string} text
 */
function wordsOf(text) {
  const comment = text.indexOf('//');
  const content = comment < 0 ? text : text.slice(0, comment);
  return Array.from(content.matchAll(/[^ \t]+/g), (match) => ({ word: match[0], at: match.index }));
}

/**
 * Returns the reason why a robot would reject the motion.
 *
 * @param {MotionDocument} document
 * @returns {string} a message about the first invalid line; empty if there is none
 */
export function problemOf({ lines }) {
  const bad = lines.flatMap(({ problem }, i) => (problem ? [`Line ${i + 1} cannot be read: ${problem}`] : []));
  return bad.length > 1 ? `${bad[0]} (${bad.length} such lines)` : (bad[0] ?? '');
}
