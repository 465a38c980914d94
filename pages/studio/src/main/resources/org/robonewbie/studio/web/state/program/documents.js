/**
 * The open file of the editor and its unsaved changes. Pure.
 *
 * @typedef {object} OpenFile
 * @property {'own' | 'example'} kind
 * @property {string} path path relative to the folder, or the name of the example
 * @property {string} version last version read by this page, empty for a file that is not on the disk yet
 * @property {string} saved its text on the disk, with the editor's line endings
 * @property {string} content the same text with the line endings of the file
 * @property {import('../decoded-text.js').Source} source its encoding
 * @property {string} problem why it cannot be decoded and is therefore read-only; empty if it can be decoded
 *
 * @typedef {object} ReadProgram
 * @property {import('../decoded-text.js').DecodedText} text
 * @property {string} version
 * @property {string} problem why it cannot be decoded; the text is then for display only
 *
 * @typedef {import('../course.js').Lesson} Lesson
 */
import { UTF_8 } from '../decoded-text.js';
import { commonLines } from './line-diff.js';
import { fileName } from './remarks.js';

/** Storage key of the most recently opened program. */
export const LAST_PROGRAM = 'robonewbie-program';

/** Default name of a program. */
export const FIRST_NAME = 'MyAgent.java';

/**
 * @param {OpenFile['kind']} kind
 * @param {string} path
 * @param {ReadProgram} program content on the disk
 * @returns {OpenFile}
 */
export function opened(kind, path, { text, version, problem }) {
  const { encoding, hasByteOrderMark, content } = text;
  return { kind, path, version, saved: normal(content), content, source: { encoding, hasByteOrderMark }, problem };
}

/** @param {string} content @param {string} [version] @returns {ReadProgram} a program without a file */
export function newText(content, version = '') {
  return { text: { ...UTF_8, content }, version, problem: '' };
}

/** @param {string} text @returns {string} the text with the editor's line endings */
export function normal(text) {
  return text.replaceAll(/\r\n?/g, '\n');
}

/**
 * Restores the line endings of the file; new lines get the line ending of the first line.
 *
 * @param {OpenFile} file
 * @param {string} text text of the editor
 * @returns {string} text for the disk
 */
export function written(file, text) {
  const parts = file.content.split(/(\r\n|\r|\n)/);
  const before = parts.filter((_, i) => i % 2 === 0);
  const ends = parts.filter((_, i) => i % 2 === 1);
  const after = text.split('\n');
  const defaultEnd = ends[0] || '\n';
  const same = commonLines(before, after);
  const rest = commonLines(before.slice(same).reverse(), after.slice(same).reverse());
  const endOf = (/** @type {number} */ i) => {
    const fromEnd = after.length - 1 - i;
    const known = i < same ? ends[i] : fromEnd < rest ? ends[before.length - 1 - fromEnd] : '';
    return known || defaultEnd;
  };
  return after.map((line, i) => (i === after.length - 1 ? line : line + endOf(i))).join('');
}

/** @param {OpenFile | undefined} file @returns {boolean} whether it is editable */
export function isOpenToChange(file) {
  return file?.kind === 'own' && file.problem === '';
}

/** @param {OpenFile | undefined} file @param {string} text text in the editor @returns {boolean} */
export function isUnsaved(file, text) {
  return file !== undefined && isOpenToChange(file) && (file.version === '' || text !== file.saved);
}

/** @param {string} path @param {readonly Lesson[]} lessons @returns {Lesson | undefined} the exercise that the file solves */
export function lessonOf(path, lessons) {
  return lessons.find(({ file }) => file === fileName(path));
}

/** @param {string} hash fragment of the page's address @returns {string} the program in it, or empty */
export function programAt(hash) {
  const [, name = ''] = /^#program\/(.+)$/.exec(hash) ?? [];
  return decodeURIComponent(name);
}

/** @param {string} name user input @returns {string} name of a Java file */
export function javaName(name) {
  return name.trim().endsWith('.java') ? name.trim() : `${name.trim()}.java`;
}

/** @param {string} name class name typed by the user @returns {string} the problem with it; empty if it is valid */
export function classNameProblem(name) {
  const letters = name.replace(/\.java$/, '');
  const wrong = [...letters].find((letter, i) => !(i === 0 ? /[\p{L}_$]/u : /[\p{L}\p{N}_$]/u).test(letter));
  if (wrong !== undefined) {
    const place = letters.startsWith(wrong) ? 'cannot begin with' : 'cannot contain';
    return `A class name ${place} ${wrong === ' ' ? 'a space' : `“${wrong}”`}.`;
  }
  return letters.length > 0 && letters.length <= 80 ? '' : 'A class name has 1 to 80 characters.';
}

/**
 * @param {string} wanted
 * @param {ReadonlyArray<{path: string}>} files
 * @returns {string} the name, with a number appended if it is taken; compared case-insensitively, as in many file systems
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
 * Returns the folder for new programs, namely the one that contains the existing programs.
 *
 * @param {ReadonlyArray<{path: string}>} files
 * @returns {string} a folder with a trailing slash, or empty
 */
export function folderOfNew(files) {
  const ofProject = files.find(({ path }) => path.startsWith('src/main/java/'));
  return ofProject ? ofProject.path.slice(0, ofProject.path.lastIndexOf('/') + 1) : '';
}
