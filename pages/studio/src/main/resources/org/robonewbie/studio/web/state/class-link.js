/** Links to the exercises that a teacher has chosen for a class. Pure. */

/** @typedef {{exercises: string[], seeds: number}} Assignment names of exercises, and number of trials */

const MARK = '#exercises?class=';
const NAME = /^[a-z0-9-]{1,40}$/;
const MAX_EXERCISES = 100;
const MAX_SEEDS = 20;

/** @param {Assignment} assignment @returns {string} fragment of the link */
export const classHash = ({ exercises, seeds }) => `${MARK}${exercises.join(',')}&seeds=${seeds}`;

/**
 * @param {string} hash fragment of an address
 * @returns {Assignment | undefined} undefined if it is not such a link
 */
export function assignmentOf(hash) {
  if (!hash.startsWith(MARK)) {
    return undefined;
  }
  const parameters = new URLSearchParams(hash.slice(hash.indexOf('?')));
  const exercises = (parameters.get('class') ?? '').split(',').filter((name) => NAME.test(name));
  const seeds = Math.trunc(Number(parameters.get('seeds')));
  return {
    exercises: [...new Set(exercises)].slice(0, MAX_EXERCISES),
    seeds: seeds >= 1 && seeds <= MAX_SEEDS ? seeds : 3,
  };
}
