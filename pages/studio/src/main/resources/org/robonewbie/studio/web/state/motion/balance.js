/**
 * Static balance of a posture: the margin of the centre of mass within the support polygon. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 *
 * @typedef {object} Balance
 * @property {number[]} centre centre of mass, metres
 * @property {number[][]} support corners of the support polygon, counter-clockwise
 * @property {number} margin metres from the centre of mass to the nearest edge; negative outside
 */
import { centreOfMass, cornersOf } from './body.js';

const TOUCH_METRES = 0.012;

/**
 * @param {Body} body
 * @param {Float64Array} poses poses of a robot on the ground
 * @returns {Balance}
 */
export function balanceOf(body, poses) {
  const touching = body.model.links
    .flatMap((link, i) => (body.links[i].solid ? cornersOf(link.size, poses, i) : []))
    .filter((corner) => corner[2] < TOUCH_METRES);
  const support = hull(touching.map(([x, y]) => [x, y]));
  const centre = centreOfMass(body, poses);
  return { centre, support, margin: marginOf(support, centre) };
}

/**
 * Convex hull by Andrew's monotone chain.
 *
 * @param {number[][]} points
 * @returns {number[][]} counter-clockwise
 */
export function hull(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (/** @type {number[][]} */ list) => {
    /** @type {number[][]} */
    const chain = [];
    for (const point of list) {
      while (chain.length > 1 && cross(chain[chain.length - 2], chain[chain.length - 1], point) <= 1e-12) {
        chain.pop();
      }
      chain.push(point);
    }
    return chain.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

/** @param {number[]} a @param {number[]} b @param {number[]} c */
function cross(a, b, c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/** @param {number[][]} polygon @param {number[]} point */
function marginOf(polygon, point) {
  if (polygon.length < 3) {
    return -Infinity;
  }
  return Math.min(
    ...polygon.map((corner, i) => {
      const next = polygon[(i + 1) % polygon.length];
      return cross(corner, next, point) / Math.hypot(next[0] - corner[0], next[1] - corner[1]);
    }),
  );
}
