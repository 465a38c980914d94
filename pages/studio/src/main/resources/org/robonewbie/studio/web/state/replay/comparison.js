/**
 * Comparison of two runs: the robots of the second run are shown as ghosts, and the distances between the runs are computed. Moments are
 * paired by the time since the start of each run. Pure.
 *
 * @typedef {import('../../live/state-frame.js').Scene} Scene
 * @typedef {import('../../live/state-frame.js').Frame} Frame
 * @typedef {{scene: Scene, frame: Frame}} Picture
 */

/** Distance up to which two paths count as equal; they are stored in hundredths of a metre. */
const MIN_METRES = 0.011;

/**
 * @param {Picture} own
 * @param {Picture} other
 * @returns {Picture} `own` with the robots of the other run added as ghosts, which have no team
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
 * @returns {Array<{name: string, metres: number}>} distances between the balls and between robots of the same team and number
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
 * @typedef {Array<[x: number, y: number]>} Way positions at equal intervals of a run
 * @typedef {{count: number, ball: Way, ways: Array<{places: Way}>}} Run
 *
 * @param {Run} own
 * @param {Run} other
 * @param {number} points
 * @returns {number[]} metres between the balls, or between the first robots if the balls agree throughout, at equal
 *     intervals of the first run
 */
export function curveOf(own, other, points) {
  const curve = (/** @type {Way} */ first, /** @type {Way} */ second) =>
    Array.from({ length: points }, (_, i) => {
      const index = Math.round((i * (own.count - 1)) / Math.max(1, points - 1));
      const [a, b] = [placeAt(first, own.count, index), placeAt(second, other.count, index)];
      return a && b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
    });
  const ball = curve(own.ball, other.ball);
  return Math.max(...ball) > MIN_METRES ? ball : curve(own.ways[0]?.places ?? [], other.ways[0]?.places ?? []);
}

/** @param {Way} way @param {number} count number of moments of the run @param {number} index index of a moment */
function placeAt(way, count, index) {
  let momentsPerPlace = 1;
  while (way.length > 0 && Math.ceil(count / momentsPerPlace) > way.length) {
    momentsPerPlace *= 2;
  }
  return way[Math.floor(index / momentsPerPlace)];
}

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
function distance(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
