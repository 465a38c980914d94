/**
 * What readers of other programs' motion files share: rows become keyframes, and a row that cannot be read is kept as it is, with
 * its place in the file. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./motion-text.js').Line} Line
 * @typedef {import('./motion-text.js').MotionDocument} MotionDocument
 *
 * @typedef {object} Imported
 * @property {MotionDocument} document
 * @property {string[]} notes what the person must know about how the file was read
 *
 * @typedef {object} Row of a foreign file
 * @property {string} text
 * @property {number} number of its line, from 1
 */
import { EMPTY_DOCUMENT, newLine } from './motion-text.js';

const LEAST_WAY = 20;

/** A row that cannot be read; the message says what was found and what was expected. */
export class UnreadableRow extends Error {}

/** @param {string} text @returns {Row[]} those that are not empty */
export function rowsOf(text) {
  return text
    .replace(/^\uFEFF/, '')
    .split(/\r\n|\r|\n/)
    .map((row, i) => ({ text: row.trim(), number: i + 1 }))
    .filter((row) => row.text !== '');
}

/**
 * @param {readonly Row[]} rows
 * @param {(row: Row) => Keyframe | string} read a keyframe or a comment; throws {@link UnreadableRow}
 * @returns {MotionDocument}
 */
export function documentOfRows(rows, read) {
  return { ...EMPTY_DOCUMENT, lines: rows.map((row) => lineOf(row, read)) };
}

/** @param {Row} row @param {(row: Row) => Keyframe | string} read @returns {Line} */
function lineOf(row, read) {
  try {
    const found = read(row);
    return typeof found === 'string' ? { text: `// ${found}`, end: '\n' } : newLine(found, '\n');
  } catch (error) {
    if (error instanceof UnreadableRow) {
      return { text: row.text, end: '\n', problem: `line ${row.number} of the file: ${error.message}` };
    }
    throw error;
  }
}

/** @param {MotionDocument} document @returns {string[]} the first line that was not read, and how many there are */
export function problemNotes({ lines }) {
  const problems = lines.flatMap(({ problem }) => (problem ? [problem] : []));
  if (problems.length === 0) {
    return [];
  }
  const others = problems.length > 1 ? `, and ${problems.length - 1} more` : '';
  return [`Not read and kept as it is: ${problems[0]}${others}. Agents refuse the file until it is mended.`];
}

/**
 * Turns moments into the times of the ways between them.
 *
 * @returns {(millis: number) => number} the way to a moment; it must be called for one after the other
 */
export function waysBetween() {
  let before = 0;
  return (millis) => {
    const way = Math.max(LEAST_WAY, Math.round(millis - before));
    before = millis;
    return way;
  };
}

/** @param {string} text @param {string} expected @returns {number} */
export function numberIn(text, expected) {
  const value = Number(text);
  if (text === '' || !Number.isFinite(value)) {
    throw new UnreadableRow(`found “${text}”, expected ${expected}`);
  }
  return value;
}

/** @param {number} degrees @returns {number} with four decimals, which is finer than any motor */
export function fourDecimals(degrees) {
  return Math.round(degrees * 1e4) / 1e4 + 0;
}
