/** Checks that file names work on Windows, macOS and Linux; letters of any language are allowed. Pure. */
import { INVALID, MAX_CHARACTERS, PROBLEMS, PROGRAM_PATH } from './file-name-patterns.js';

/**
 * Normalises a name: macOS writes some letters as two characters, whereas other systems write them as one.
 *
 * @param {string} name
 * @returns {string} the normalised name
 */
export function composedName(name) {
  return name.normalize('NFC');
}

/**
 * @param {string} name without folder and extension
 * @returns {string} the problem with it, such as: contains "/"; empty if it is valid
 */
export function nameProblem(name) {
  if (name.length > MAX_CHARACTERS) {
    return `has ${name.length} characters, more than the ${MAX_CHARACTERS} allowed`;
  }
  const [wrong] = INVALID.exec(name) ?? [name];
  const code = wrong.charCodeAt(0).toString(16).toUpperCase().padStart(4, '0');
  const problem = PROBLEMS.find(({ pattern }) => pattern.test(wrong));
  return problem?.words.replace('SIGN', wrong).replace('CODE', `U+${code}`) ?? '';
}

/** @param {string} path @returns {boolean} whether a program can have this path */
export function isProgramPath(path) {
  const names = path.replace('.java', '').split('/');
  return names.every((name) => nameProblem(name) === '') && PROGRAM_PATH.test(path);
}
