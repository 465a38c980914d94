/** Ring around an object: dragging it turns a robot or throws the ball. Pure. */

const RING_METRES = { ball: 0.17, robot: 0.36 };
const RING_PIXELS = { ball: 22, robot: 34 };
const RING_WIDTH = 0.36;
const DEAD_METRES = 0.06;
const SPEED_PER_METRE = 2.5;
const HIGH_PART = 0.6;

/** Maximum speed of a throw in metres per second, faster than the hardest known kick of any team. */
export const FASTEST_THROW = 12;

/** @typedef {'ball' | 'robot'} Kind */

/** @param {Kind} kind @param {number} metresPerPixel at its position @returns {number} radius of the ring, metres */
export function ringRadius(kind, metresPerPixel) {
  return Math.max(RING_METRES[kind], RING_PIXELS[kind] * metresPerPixel);
}

/**
 * Returns whether a point on the ground is on the ring.
 *
 * @param {ArrayLike<number>} centre
 * @param {ArrayLike<number>} point
 * @param {number} radius
 */
export function isOnRing(centre, point, radius) {
  const metres = Math.hypot(point[0] - centre[0], point[1] - centre[1]);
  return Math.abs(metres - radius) <= (RING_WIDTH / 2) * radius;
}

/**
 * @param {ArrayLike<number>} centre
 * @param {ArrayLike<number>} point pointer position
 * @returns {number | undefined} the heading in degrees; undefined if the pointer is on the robot itself
 */
export function headingTo(centre, point) {
  const [x, y] = [point[0] - centre[0], point[1] - centre[1]];
  return Math.hypot(x, y) < DEAD_METRES ? undefined : (Math.atan2(y, x) * 180) / Math.PI;
}

/**
 * Returns the flight of the ball when it is released: the longer the drag, the faster the ball.
 *
 * @param {ArrayLike<number>} ball
 * @param {ArrayLike<number>} point pointer position
 * @param {boolean} high whether the ball flies over robots
 * @returns {{velocity: [number, number, number], speed: number} | undefined} velocity and speed in metres per second; undefined if the ball
 *     does not move
 */
export function throwOf(ball, point, high) {
  const [x, y] = [point[0] - ball[0], point[1] - ball[1]];
  const metres = Math.hypot(x, y);
  if (metres < DEAD_METRES) {
    return undefined;
  }
  const flat = Math.min(FASTEST_THROW, SPEED_PER_METRE * metres);
  const up = high ? HIGH_PART * flat : 0;
  return { velocity: [(flat * x) / metres, (flat * y) / metres, up], speed: Math.hypot(flat, up) };
}
