/**
 * Diagnostics from the compiler and the robot for individual lines of a program. Pure.
 *
 * @typedef {object} Remark compiler diagnostic
 * @property {number} from index of the first character, -1 for the whole line
 * @property {number} to index after the last one
 * @property {number} line line number from 1, 0 if it is not in this file
 * @property {boolean} serious whether it is an error
 * @property {string} text message from the compiler
 * @property {string} hint what to do, or empty
 *
 * @typedef {{line: number, text: string}} Mistake a runtime error at a line
 */

const PLACE = /\(([\w$]+\.java):(\d+)\)/;
const MAX_MISTAKES = 5;

/** @param {string} path @returns {string} the name of a file without its folders */
export function fileName(path) {
  return path.slice(path.lastIndexOf('/') + 1);
}

/**
 * Finds the line of a file to which a robot's message refers.
 *
 * @param {string} text text such as `think() failed with … (MyAgent.java:31)`
 * @param {string} path path of the file
 * @returns {number} line number from 1, 0 if it refers to another file
 */
export function lineOf(text, path) {
  const place = PLACE.exec(text);
  return place?.[1] === fileName(path) ? Number(place[2]) : 0;
}

/**
 * Adds a runtime error, replacing any previous one on the same line.
 *
 * @param {readonly Mistake[]} mistakes
 * @param {Mistake} mistake
 * @returns {readonly Mistake[]}
 */
export function withMistake(mistakes, mistake) {
  const others = mistakes.filter(({ line }) => line !== mistake.line);
  return [...others, mistake].slice(-MAX_MISTAKES);
}

/** @param {readonly Remark[]} remarks @returns {string} the number of errors and warnings, as a sentence */
export function remarksText(remarks) {
  const serious = remarks.filter((remark) => remark.serious).length;
  const first = remarks.find((remark) => remark.serious && remark.line > 0);
  if (serious === 0) {
    return remarks.length === 0 ? 'No errors' : 'No errors, but a warning';
  }
  return `${serious === 1 ? '1 error' : `${serious} errors`}${first ? `, line ${first.line}` : ''}`;
}

/**
 * Returns the range of a diagnostic in the text.
 *
 * @param {Remark} remark
 * @param {number} length length of the text
 * @returns {{from: number, to: number} | undefined} at least one character, if there is one; undefined if it has no position
 */
export function rangeOf({ from, to, line }, length) {
  if (line === 0 || from < 0 || from > length) {
    return undefined;
  }
  const end = Math.min(length, Math.max(to, from + 1));
  return { from: Math.min(from, Math.max(0, end - 1)), to: end };
}
