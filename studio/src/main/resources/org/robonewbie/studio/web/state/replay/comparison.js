/**
 * Two runs side by side: the second one is shown as ghosts, and the distances between the two are told. Moments are paired by their
 * time since the start. Pure.
 *
 * @typedef {import('./recording-reader.js').Moment} Moment
 * @typedef {import('../../live/state-frame.js').Scene} Scene
 * @typedef {import('../../live/state-frame.js').Frame} Frame
 * @typedef {{scene: Scene, frame: Frame}} Picture
 */

const STEPS_PER_METRE = 10_000;
const POSE_NUMBERS = 7;

/**
 * @param {Picture} own
 * @param {Picture} other
 * @returns {Picture} the own run with the robots of the other one as ghosts, which belong to no team
 */
export function withGhosts(own, other) {
  const ghosts = other.scene.robots.map((player) => ({
    ...player,
    id: -1 - player.id,
    side: /** @type {const} */ (''),
    number: 0,
    team: `Ghost of ${player.team} ${player.number}`,
  }));
  return {
    scene: { ...own.scene, robots: [...own.scene.robots, ...ghosts] },
    frame: { ...own.frame, robots: [...own.frame.robots, ...other.frame.robots] },
  };
}

/**
 * @param {Picture} own
 * @param {Picture} other
 * @returns {Array<{name: string, metres: number}>} how far ball and robots of the same team and number are apart
 */
export function differences(own, other) {
  const robots = own.scene.robots.flatMap(({ team, number }, i) => {
    const twin = other.scene.robots.findIndex((each) => each.team === team && each.number === number);
    return twin < 0
      ? []
      : [{ name: `${team} ${number}`, metres: distance(own.frame.robots[i].torso, other.frame.robots[twin].torso) }];
  });
  return [{ name: 'ball', metres: distance(own.frame.ball, other.frame.ball) }, ...robots];
}

/**
 * @param {readonly Moment[]} own
 * @param {readonly Moment[]} other
 * @param {number} points
 * @returns {number[]} metres between the balls, or between the first robots where the balls agree throughout, evenly over the own run
 */
export function curveOf(own, other, points) {
  const curve = (/** @type {number} */ at) =>
    Array.from({ length: points }, (_, i) => {
      const index = Math.round((i * (own.length - 1)) / Math.max(1, points - 1));
      const [a, b] = [own[index]?.numbers, other[index]?.numbers];
      return a && b && at + 2 < a.length && at + 2 < b.length
        ? Math.hypot(a[at] - b[at], a[at + 1] - b[at + 1], a[at + 2] - b[at + 2]) / STEPS_PER_METRE
        : 0;
    });
  const ball = curve(0);
  return Math.max(...ball) > 0.001 ? ball : curve(POSE_NUMBERS);
}

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
function distance(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
