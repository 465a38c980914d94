/**
 * The file that is open in the editor, and what is unsaved of it. Pure.
 *
 * @typedef {object} OpenFile
 * @property {'own' | 'example'} shelf
 * @property {string} path from the folder on, or the name of the example
 * @property {string} version that this page has seen, empty for a file that is not on the disk yet
 * @property {string} saved its text on the disk
 * @property {boolean} crlf whether its lines end as Windows ends them
 *
 * @typedef {import('../course.js').Lesson} Lesson
 */
import { fileName } from './remarks.js';

/** Under what a browser remembers which program was open. */
export const LAST_PROGRAM = 'robonewbie-program';

/** The name of a program that was never named. */
export const FIRST_NAME = 'MyAgent.java';

/**
 * @param {OpenFile['shelf']} shelf
 * @param {string} path
 * @param {string} text as it is on the disk
 * @param {string} version
 * @returns {OpenFile}
 */
export function opened(shelf, path, text, version) {
  return { shelf, path, version, saved: normal(text), crlf: text.includes('\r\n') };
}

/** @param {string} text @returns {string} with lines as the editor has them */
export function normal(text) {
  return text.replaceAll(/\r\n?/g, '\n');
}

/** @param {OpenFile} file @param {string} text of the editor @returns {string} as it goes to the disk */
export function written(file, text) {
  return file.crlf ? text.replaceAll('\n', '\r\n') : text;
}

/** @param {OpenFile | undefined} file @param {string} text of the editor @returns {boolean} */
export function isUnsaved(file, text) {
  return file?.shelf === 'own' && (file.version === '' || text !== file.saved);
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
