/** Links to the exercises that a teacher has chosen for a class. Pure. */

/** @typedef {{exercises: string[], seeds: number}} Assignment names of exercises, and number of trials */

const MARK = '#exercises?class=';
const LINK = /^#exercises\?class=([a-z0-9-]+(?:,[a-z0-9-]+)*)&seeds=([1-9]|1\d|20)$/;
const DAMAGED = 'The link of your class is incomplete or damaged. Copy the whole link that your teacher has sent.';

/** @param {Assignment} assignment @returns {string} fragment of the link */
export const classHash = ({ exercises, seeds }) => `${MARK}${exercises.join(',')}&seeds=${seeds}`;

/** @param {string} hash fragment of an address @returns {boolean} whether it starts like a class link, even if the rest is damaged */
export const isClassLink = (hash) => hash.startsWith(MARK);

/**
 * @param {string} hash fragment of a class link; mail programs may have encoded its commas
 * @returns {Assignment}
 * @throws {Error} if the link is incomplete; the message is meant for the user
 */
export function assignmentOf(hash) {
  const [, exercises, seeds] = LINK.exec(hash.replaceAll(/%2c/gi, ',')) ?? [];
  if (exercises === undefined) {
    throw new Error(DAMAGED);
  }
  return { exercises: [...new Set(exercises.split(','))], seeds: Number(seeds) };
}
