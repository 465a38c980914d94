/**
 * Triangulates RoboViz drawings. Pure.
 *
 * @typedef {object} BoardShape
 * @property {'circle' | 'line' | 'point' | 'sphere' | 'polygon' | 'text' | 'agent'} shape
 * @property {number[]} [numbers] numbers in the order of RoboViz's protocol, in metres, except line thickness and point size, which are in
 *     pixels
 * @property {string} colour
 * @property {number} [opacity]
 * @property {string} text
 * @property {'left' | 'right'} [side] side of the team, for a label above a robot
 * @property {number} [number]
 */
import { raised, ring } from './drawing-shapes.js';

const METRES_PER_PIXEL = 0.012;
const PARTS = 40;
const OVER_GROUND = 0.013;

/** @typedef {[number, number, number]} Point */

/** @param {BoardShape} shape @returns {number[]} x, y and z of three vertices per triangle; empty for a label */
export function boardTriangles({ shape, numbers: n = [] }) {
  const half = (METRES_PER_PIXEL * n[shape === 'line' ? 6 : 3]) / 2;
  switch (shape) {
    case 'circle':
      return raised(ring(n, Math.max(0, n[2] - half), n[2] + half, PARTS), OVER_GROUND);
    case 'line':
      return beam([n[0], n[1], over(n[2])], [n[3], n[4], over(n[5])], half);
    case 'point':
      return octahedron([n[0], n[1], over(n[2])], half);
    case 'sphere':
      return ball([n[0], n[1], n[2]], n[3]);
    case 'polygon':
      return fan(n);
    default:
      return [];
  }
}

/** Raises shapes that lie on the ground, to avoid z-fighting. @param {number} z */
function over(z) {
  return Math.abs(z) < OVER_GROUND ? OVER_GROUND : z;
}

/** Returns two crossed ribbons, so that a line is visible from all sides. @param {Point} a @param {Point} b @param {number} half */
function beam(a, b, half) {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const flat = Math.hypot(dx, dy);
  const side = flat > 1e-6 ? [(-dy / flat) * half, (dx / flat) * half, 0] : [half, 0, 0];
  const up = flat > 1e-6 ? [0, 0, half] : [0, half, 0];
  return [side, up].flatMap((by) => quad(plus(a, by), plus(a, by, -1), plus(b, by), plus(b, by, -1)));
}

/** @param {Point} point @param {number[]} by @param {number} [times] @returns {Point} */
function plus(point, by, times = 1) {
  return [point[0] + times * by[0], point[1] + times * by[1], point[2] + times * by[2]];
}

/** @param {Point} centre @param {number} r */
function octahedron(centre, r) {
  return ball(centre, r, 4, 2);
}

/** @param {Point} centre @param {number} r @param {number} [around] @param {number} [high] */
function ball([x, y, z], r, around = 16, high = 8) {
  const at = (/** @type {number} */ i, /** @type {number} */ j) => {
    const [turn, rise] = [(2 * Math.PI * i) / around, Math.PI * (j / high - 0.5)];
    const flat = r * Math.cos(rise);
    return /** @type {Point} */ ([x + flat * Math.cos(turn), y + flat * Math.sin(turn), z + r * Math.sin(rise)]);
  };
  return Array.from({ length: around * high }, (_, k) => {
    const [i, j] = [k % around, Math.floor(k / around)];
    return quad(at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1));
  }).flat();
}

/** @param {number[]} numbers x, y and z of each vertex */
function fan(numbers) {
  const corner = (/** @type {number} */ i) => [numbers[3 * i], numbers[3 * i + 1], over(numbers[3 * i + 2])];
  const count = Math.floor(numbers.length / 3);
  return Array.from({ length: Math.max(0, count - 2) }, (_, i) =>
    [corner(0), corner(i + 1), corner(i + 2)].flat(),
  ).flat();
}

/** @param {Point} a @param {Point} b @param {Point} c next to a @param {Point} d next to b */
function quad(a, b, c, d) {
  return [...a, ...b, ...c, ...c, ...b, ...d];
}
