/**
 * Three one-minute levels for newcomers: determines the next level and the changes that its program still lacks. Pure.
 *
 * @typedef {object} Level
 * @property {string} name
 * @property {string} title
 * @property {string} goal
 * @property {string} file path of its program
 * @property {boolean} passed
 * @property {string} start starter program
 * @property {string} solution the same program with the lines that the newcomer changes
 *
 * @typedef {'level' | 'edit' | 'run' | 'watch' | 'passed' | 'failed' | 'broken' | 'next' | 'finish' | 'skip' | 'skipHint'} Word
 * @typedef {{levels: Level[], words: Record<Word, string>}} FirstMinute
 * @typedef {{language: string, lessons: import('../course.js').Lesson[], firstMinute?: FirstMinute}} Course
 *
 * @typedef {object} Ghost a proposed change
 * @property {number} from offset of the replaced text
 * @property {number} to
 * @property {string} insert
 * @property {string} line the whole statement after the change
 */

/** Storage key of the newcomer's choice to skip the levels. */
export const SKIPPED = 'robonewbie-first-minute-skipped';

/**
 * Returns the next level for a newcomer: a user with no progress in the exercises and no programs other than those of the levels, in a
 * studio that was not opened by a running program.
 *
 * @param {Course} course
 * @param {{open: boolean, own: ReadonlyArray<{path: string}>, drafts: ReadonlyArray<{path: string}>, first?: object}} programs
 * @returns {Level | undefined} undefined for all other users
 */
export function nextLevel({ lessons, firstMinute }, { open, own, drafts, first }) {
  const levels = firstMinute?.levels ?? [];
  const isNew = lessons.every(({ standing }) => standing.tries === 0);
  const ofLevels = [...own, ...drafts].every(({ path }) => levels.some(({ file }) => file === path));
  return open && !first && isNew && ofLevels ? levels.find(({ passed }) => !passed) : undefined;
}

/**
 * Returns the first change that a program still lacks.
 *
 * @param {string} text
 * @param {Level} level
 * @returns {Ghost | undefined} undefined if it is complete, or if the newcomer has written something else there
 */
export function ghostOf(text, { start, solution }) {
  const before = start.split('\n');
  const after = solution.split('\n');
  const lines = linesOf(text);
  const find = (/** @type {string} */ wanted) => lines.findIndex((line) => line.text.trim() === wanted.trim());
  const missing = after.findIndex((line, i) => line !== before[i] && find(line) < 0);
  if (missing < 0) {
    return undefined;
  }
  const here = lines[before[missing].trim() === '' ? find(after[missing - 1]) + 1 : find(before[missing])];
  return here && changed(here, before[missing], after[missing]);
}

/** @param {string} text */
function linesOf(text) {
  let from = 0;
  return text.split('\n').map((line) => {
    const here = { from, text: line };
    from += line.length + 1;
    return here;
  });
}

/** @param {{from: number, text: string}} here @param {string} before @param {string} after @returns {Ghost | undefined} */
function changed({ from, text }, before, after) {
  const line = after.trim().replace(/ \/\/.*/, '');
  const to = from + text.length;
  if (text.trim() === '') {
    return { from, to, insert: after, line };
  }
  if (before.trim() === '') {
    return line.startsWith(text.trim()) ? { from: to, to, insert: line.slice(text.trim().length), line } : undefined;
  }
  const start = sameWords(before, after);
  const rest = sameWords([...before].reverse().join(''), [...after].reverse().join(''));
  const indent = text.search(/\S/) - before.search(/\S/);
  return { from: from + start + indent, to: to - rest, insert: after.slice(start, after.length - rest), line };
}

/** Returns the length of the common words at the beginning. @param {string} one @param {string} other */
function sameWords(one, other) {
  const words = one.split(/\b/);
  const others = other.split(/\b/);
  return words
    .slice(
      0,
      words.findIndex((word, i) => word !== others[i]),
    )
    .join('').length;
}
