/** Visibility and text of the name tags. Pure. */

/** Minimum height of a robot with a name tag; the tag of a smaller robot would be larger than the robot. */
export const MIN_ROBOT_PIXELS = 16;

const MAX_TEAM = 14;
const GAP_PIXELS = 2;

/**
 * @typedef {object} Tag a name tag at its position on the page
 * @property {number} x centre of its lower edge, pixels
 * @property {number} y
 * @property {number} width pixels
 * @property {number} height
 * @property {number} metres distance of the robot from the camera
 * @property {number} robotPixels height of the robot in pixels
 */

/** @param {{team: string, number: number}} player */
export function nameOf({ team, number }) {
  const name = team.length > MAX_TEAM ? `${team.slice(0, MAX_TEAM - 1)}…` : team;
  return number > 0 ? `${name} ${number}`.trim() : name || 'new robot';
}

/**
 * Chooses the visible tags: none for tiny robots, and only the nearer one of two that would overlap.
 *
 * @param {readonly Tag[]} tags
 * @returns {boolean[]} whether each is shown
 */
export function shownTags(tags) {
  /** @type {Tag[]} */
  const shown = [];
  const nearest = [...tags].sort((a, b) => a.metres - b.metres);
  for (const tag of nearest) {
    if (tag.robotPixels >= MIN_ROBOT_PIXELS && !shown.some((other) => cover(tag, other))) {
      shown.push(tag);
    }
  }
  return tags.map((tag) => shown.includes(tag));
}

/** @param {Tag} a @param {Tag} b */
function cover(a, b) {
  const apart = Math.abs(a.x - b.x) >= (a.width + b.width) / 2 + GAP_PIXELS;
  const above = a.y - a.height >= b.y + GAP_PIXELS || b.y - b.height >= a.y + GAP_PIXELS;
  return !apart && !above;
}
