/**
 * The solutions of the exercises, if this page has them: a teacher has put the folder `solutions` of the teachers' zip beside it. Its
 * file `locked.txt` names exercises, one a line, whose solution nobody is shown yet; `all` locks all.
 */

const FOLDER = 'solutions';
const PACKAGE = /^package .*;(\r?\n)+/m;

/**
 * @typedef {{name: string, fullName: string, number: number, file: string}} Exercise
 */

/** @param {Exercise} exercise @returns {Promise<string>} the program; empty if there is none, or none that one may see */
export async function solutionOf(exercise) {
  if (isLocked(exercise, await text('locked.txt').catch(() => 'all'))) {
    return '';
  }
  const program = await text(exercise.file).catch(() => '');
  return program.replace(PACKAGE, '');
}

/** @param {Exercise} exercise @param {string} locks lines of the file */
function isLocked({ name, fullName, number }, locks) {
  const names = [name, fullName, String(number)];
  return locks.split('\n').some((line) => {
    const word = line.trim();
    return word.toLowerCase() === 'all' || names.includes(word);
  });
}

/** @param {string} file */
async function text(file) {
  const answer = await fetch(`${FOLDER}/${file}`, { cache: 'no-cache' });
  if (!answer.ok) {
    throw new Error(`There is no ${file}.`);
  }
  return answer.text();
}
