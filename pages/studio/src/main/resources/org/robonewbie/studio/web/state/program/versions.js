/**
 * The history of a program: the last twenty versions saved under its name, each different from the previous one. The history outlives the
 * file. Pure.
 *
 * @typedef {object} Version
 * @property {number} time when it was saved, in milliseconds; 0 if another program saved it
 * @property {string} text with the editor's line endings
 */

export const MAX_VERSIONS = 20;
/** Longer programs are not kept. */
const MAX_CHARACTERS = 50_000;

const UNITS = /** @type {const} */ ([
  ['day', 86_400],
  ['hour', 3600],
  ['minute', 60],
]);
const AGES = new Intl.RelativeTimeFormat('en');

/** @param {any} stored stored versions, perhaps damaged @returns {Version[]} */
export function versionsFrom(stored) {
  const versions = Array.isArray(stored) ? stored : [];
  return versions.filter((each) => Number.isFinite(each?.time) && typeof each.text === 'string').slice(-MAX_VERSIONS);
}

/**
 * @param {Version[]} versions oldest first
 * @param {Version} version
 * @returns {Version[]} the versions including the new one, without the oldest if there are too many; unchanged if the latest one has the
 *     same text
 */
export function withVersion(versions, version) {
  return versions.at(-1)?.text === version.text || version.text.length > MAX_CHARACTERS
    ? versions
    : [...versions, version].slice(-MAX_VERSIONS);
}

/** @param {number} time @param {number} now @returns {string} how long ago a version was saved */
export function ageText(time, now) {
  if (time === 0) {
    return 'earlier';
  }
  const seconds = (now - time) / 1000;
  const unit = UNITS.find(([, length]) => seconds >= length);
  return unit ? AGES.format(-Math.floor(seconds / unit[1]), unit[0]) : 'just now';
}
