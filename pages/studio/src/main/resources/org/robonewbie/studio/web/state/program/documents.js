/**
 * The file that is open in the editor, and what is unsaved of it. Pure.
 *
 * @typedef {object} OpenFile
 * @property {'own' | 'example'} shelf
 * @property {string} path from the folder on, or the name of the example
 * @property {string} version that this page has seen, empty for a file that is not on the disk yet
 * @property {string} saved its text on the disk, with lines as the editor has them
 * @property {string} content the same with the line ends of the file
 * @property {import('../decoded-text.js').Source} source how it is encoded
 * @property {string} problem why it cannot be decoded, and so is only shown; nothing for a file that can
 *
 * @typedef {object} ReadProgram
 * @property {import('../decoded-text.js').DecodedText} text
 * @property {string} version
 * @property {string} problem why it cannot be decoded; the text is to be looked at only then
 *
 * @typedef {import('../course.js').Lesson} Lesson
 */
import { UTF_8 } from '../decoded-text.js';
import { fileName } from './remarks.js';

/** Under what a browser remembers which program was open. */
export const LAST_PROGRAM = 'robonewbie-program';

/** The name of a program that was never named. */
export const FIRST_NAME = 'MyAgent.java';

/**
 * @param {OpenFile['shelf']} shelf
 * @param {string} path
 * @param {ReadProgram} program as it is on the disk
 * @returns {OpenFile}
 */
export function opened(shelf, path, { text, version, problem }) {
  const { encoding, hasByteOrderMark, content } = text;
  return { shelf, path, version, saved: normal(content), content, source: { encoding, hasByteOrderMark }, problem };
}

/** @param {string} content @param {string} [version] @returns {ReadProgram} a program that was not read from a file */
export function newText(content, version = '') {
  return { text: { ...UTF_8, content }, version, problem: '' };
}

/** @param {string} text @returns {string} with lines as the editor has them */
export function normal(text) {
  return text.replaceAll(/\r\n?/g, '\n');
}

/**
 * Gives the lines of the editor the ends that they have in the file; new lines end as its first one.
 *
 * @param {OpenFile} file
 * @param {string} text of the editor
 * @returns {string} as it goes to the disk
 */
export function written(file, text) {
  const parts = file.content.split(/(\r\n|\r|\n)/);
  const before = parts.flatMap((line, i) => (i % 2 === 0 ? [{ line, end: parts[i + 1] ?? '' }] : []));
  const after = text.split('\n');
  const usual = before[0].end || '\n';
  const same = sameLines(before, after);
  const rest = sameLines(before.slice(same).reverse(), after.slice(same).reverse());
  const endOf = (/** @type {number} */ i) => {
    const fromEnd = after.length - 1 - i;
    const known = i < same ? before[i] : fromEnd < rest ? before[before.length - 1 - fromEnd] : undefined;
    return known?.end || usual;
  };
  return after.map((line, i) => (i === after.length - 1 ? line : line + endOf(i))).join('');
}

/** How many lines at the beginning are alike. @param {Array<{line: string}>} before @param {string[]} after */
function sameLines(before, after) {
  const first = after.findIndex((line, i) => line !== before[i]?.line);
  return first < 0 ? after.length : first;
}

/** @param {OpenFile | undefined} file @returns {boolean} whether it can be changed */
export function isOpenToChange(file) {
  return file?.shelf === 'own' && file.problem === '';
}

/** @param {OpenFile | undefined} file @param {string} text of the editor @returns {boolean} */
export function isUnsaved(file, text) {
  return file !== undefined && isOpenToChange(file) && (file.version === '' || text !== file.saved);
}

/** @param {string} path @param {readonly Lesson[]} lessons @returns {Lesson | undefined} the exercise that a file solves */
export function lessonOf(path, lessons) {
  return lessons.find(({ file }) => file === fileName(path));
}

/** @param {string} hash end of the page's address @returns {string} the program that it names, or nothing */
export function programAt(hash) {
  const [, name = ''] = /^#program\/(.+)$/.exec(hash) ?? [];
  return decodeURIComponent(name);
}

/** @param {string} name what a person has typed @returns {string} the name of a Java file */
export function javaName(name) {
  return name.trim().endsWith('.java') ? name.trim() : `${name.trim()}.java`;
}

/** @param {string} name what a person has typed for a class @returns {string} what is wrong with it; nothing if it is good */
export function classNameProblem(name) {
  const letters = name.replace(/\.java$/, '');
  const wrong = [...letters].find((letter, i) => !(i === 0 ? /[\p{L}_$]/u : /[\p{L}\p{N}_$]/u).test(letter));
  if (wrong !== undefined) {
    const place = letters.startsWith(wrong) ? 'cannot begin with' : 'cannot contain';
    return `The name of a class ${place} ${wrong === ' ' ? 'a blank' : `“${wrong}”`}.`;
  }
  return letters.length > 0 && letters.length <= 80 ? '' : 'The name of a class has 1 to 80 letters.';
}

/**
 * @param {string} wanted
 * @param {ReadonlyArray<{path: string}>} files
 * @returns {string} the name, with a number if it is taken; many disks take capital and small letters for the same
 */
export function freeName(wanted, files) {
  const taken = new Set(files.map(({ path }) => path.toLowerCase()));
  const stem = wanted.replace(/\.java$/, '');
  let name = wanted;
  for (let number = 2; taken.has(name.toLowerCase()); number += 1) {
    name = `${stem}${number}.java`;
  }
  return name;
}

/**
 * Where new programs of a folder belong: beside those that are there.
 *
 * @param {ReadonlyArray<{path: string}>} files
 * @returns {string} a folder with a slash at its end, or nothing
 */
export function folderOfNew(files) {
  const ofProject = files.find(({ path }) => path.startsWith('src/main/java/'));
  return ofProject ? ofProject.path.slice(0, ofProject.path.lastIndexOf('/') + 1) : '';
}
