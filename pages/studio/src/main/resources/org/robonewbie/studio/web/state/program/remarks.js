/**
 * What compiler and robot say about lines of a program. Pure.
 *
 * @typedef {object} Remark what the compiler says
 * @property {number} from index of the first character that is meant, -1 for the whole line
 * @property {number} to index after the last one
 * @property {number} line from 1, 0 if it has no place in this file
 * @property {boolean} serious whether the program cannot run because of it
 * @property {string} text the compiler's own words
 * @property {string} hint what to do, or nothing
 *
 * @typedef {{line: number, text: string}} Mistake what has gone wrong in a line while the program ran
 */

const PLACE = /\(([\w$]+\.java):(\d+)\)/;
const MOST_MISTAKES = 5;

/** @param {string} path @returns {string} the name of a file without its folders */
export function fileName(path) {
  return path.slice(path.lastIndexOf('/') + 1);
}

/**
 * Finds the line of a file that a robot's message is about.
 *
 * @param {string} text such as `think() failed with … (MyAgent.java:31)`
 * @param {string} path of the file
 * @returns {number} from 1, 0 if it is about another place
 */
export function lineOf(text, path) {
  const place = PLACE.exec(text);
  return place?.[1] === fileName(path) ? Number(place[2]) : 0;
}

/**
 * Adds a mistake of the running program; the same words about the same line are said once.
 *
 * @param {readonly Mistake[]} mistakes
 * @param {Mistake} mistake
 * @returns {readonly Mistake[]}
 */
export function withMistake(mistakes, mistake) {
  const others = mistakes.filter(({ line, text }) => line !== mistake.line || text !== mistake.text);
  return [...others, mistake].slice(-MOST_MISTAKES);
}

/** @param {readonly Remark[]} remarks @returns {string} how many mistakes there are, as a sentence */
export function remarksText(remarks) {
  const serious = remarks.filter((remark) => remark.serious).length;
  const first = remarks.find((remark) => remark.serious && remark.line > 0);
  if (serious === 0) {
    return remarks.length === 0 ? 'No mistakes' : 'No mistakes, but a warning';
  }
  return `${serious === 1 ? '1 mistake' : `${serious} mistakes`}${first ? `, line ${first.line}` : ''}`;
}

/**
 * Where in the text a remark is shown.
 *
 * @param {Remark} remark
 * @param {number} length of the text
 * @returns {{from: number, to: number} | undefined} at least one character if there is one; nothing if it has no place
 */
export function rangeOf({ from, to, line }, length) {
  if (line === 0 || from < 0 || from > length) {
    return undefined;
  }
  const end = Math.min(length, Math.max(to, from + 1));
  return { from: Math.min(from, Math.max(0, end - 1)), to: end };
}
