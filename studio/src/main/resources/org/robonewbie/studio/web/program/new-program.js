/** What a new program is called. */
import { ask } from '../motion/questions.js';
import { classNameProblem, FIRST_NAME, folderOfNew, freeName, javaName } from '../state/program/documents.js';

/** @typedef {ReadonlyArray<{path: string}>} Files */

/** @param {string} example what to begin with, or nothing @param {Files} own @returns {Promise<string | undefined>} nothing if the person wants none */
export async function askPath(example, own) {
  const folder = folderOfNew(own);
  const name = await ask({
    title: example ? 'Make my own copy' : 'New program',
    label: 'Name',
    value: freePath(example, own)
      .slice(folder.length)
      .replace(/\.java$/, ''),
    action: 'Make it',
    problem: classNameProblem,
    hint: 'The name of a class: letters and digits, a capital letter first.',
  });
  return name && folder + javaName(name);
}

/** @param {string} example @param {Files} own @returns {string} a free path for a program that begins with it */
export function freePath(example, own) {
  const wanted = example ? `My${example.replace(/^Agent_/, '')}.java` : FIRST_NAME;
  return freeName(folderOfNew(own) + wanted, own);
}
