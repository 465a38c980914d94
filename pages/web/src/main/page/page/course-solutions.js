/**
 * Solutions of the exercises, if a teacher has put the folder `solutions` of the teachers' zip beside this page. Its file `locked.txt`
 * lists exercises whose solution must not be shown yet, one per line; `all` locks all.
 */

const FOLDER = 'solutions';
const PACKAGE = /^package .*;(\r?\n)+/m;

/**
 * @typedef {{name: string, fullName: string, number: number, file: string}} Exercise
 */

/** @param {Exercise} exercise @returns {Promise<string>} the program; empty if there is none or it is locked */
export async function solutionOf(exercise) {
  if (isLocked(exercise, await text('locked.txt').catch(() => 'all'))) {
    return '';
  }
  const program = await text(exercise.file).catch(() => '');
  return program.replace(PACKAGE, '');
}

/** @param {Exercise} exercise @param {string} locks content of the file */
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
