/**
 * Transforms drawings from the robot's head frame to the ground and triangulates them. Pure.
 *
 * @typedef {import('./robot/telemetry.js').Drawing} Drawing
 * @typedef {{x: number, y: number, cos: number, sin: number}} Stand position on the ground below a robot's head, and the robot's heading
 */
import { headingDegrees, POSE } from './kinematics.js';

const LINE_METRES = 0.035;
const POINT_METRES = 0.08;
const CIRCLE_PARTS = 48;
const POINT_PARTS = 16;

/**
 * @param {ArrayLike<number>} poses poses of all links of a robot, the torso first
 * @param {number} head link index of its head
 * @returns {Stand}
 */
export function standOf(poses, head) {
  const heading = (headingDegrees(poses) * Math.PI) / 180;
  return { x: poses[head * POSE], y: poses[head * POSE + 1], cos: Math.cos(heading), sin: Math.sin(heading) };
}

/** @param {Stand} stand @param {number[]} place metres forward and left @returns {[number, number]} x and y in the world */
export function onGround({ x, y, cos, sin }, [forward, left]) {
  return [x + forward * cos - left * sin, y + forward * sin + left * cos];
}

/** @param {Drawing} drawing @returns {boolean} whether all its numbers are finite */
export function isDrawable({ place, to, radius }) {
  return [...place, ...to, radius].every(Number.isFinite);
}

/**
 * @param {Stand} stand
 * @param {Drawing} drawing
 * @returns {number[]} x and y of three vertices per triangle; empty for a label
 */
export function trianglesOf(stand, { shape, place, to, radius }) {
  const at = onGround(stand, place);
  if (shape === 'line') {
    return ribbon(at, onGround(stand, to));
  }
  if (shape === 'circle') {
    return ring(at, Math.max(0, radius - LINE_METRES / 2), radius + LINE_METRES / 2, CIRCLE_PARTS);
  }
  return shape === 'point' ? ring(at, 0, POINT_METRES, POINT_PARTS) : [];
}

/** @param {number[]} from @param {number[]} to */
function ribbon([x, y], [toX, toY]) {
  const length = Math.hypot(toX - x, toY - y) || 1;
  const [sideX, sideY] = [((y - toY) / length) * (LINE_METRES / 2), ((toX - x) / length) * (LINE_METRES / 2)];
  return quad([x + sideX, y + sideY], [x - sideX, y - sideY], [toX + sideX, toY + sideY], [toX - sideX, toY - sideY]);
}

/** @param {readonly number[]} places x and y of each vertex @param {number} z @returns {number[]} x, y and z of each vertex */
export function raised(places, z) {
  return places.flatMap((value, i) => (i % 2 === 0 ? [value] : [value, z]));
}

/**
 * @param {number[]} centre
 * @param {number} inner
 * @param {number} outer
 * @param {number} parts
 * @returns {number[]} x and y of three vertices per triangle
 */
export function ring([x, y], inner, outer, parts) {
  const corner = (/** @type {number} */ radius, /** @type {number} */ part) => {
    const angle = (2 * Math.PI * part) / parts;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  };
  return Array.from({ length: parts }, (_, i) =>
    quad(corner(inner, i), corner(outer, i), corner(inner, i + 1), corner(outer, i + 1)),
  ).flat();
}

/** @param {number[]} a @param {number[]} b @param {number[]} c next to a @param {number[]} d next to b */
function quad(a, b, c, d) {
  return [...a, ...b, ...c, ...c, ...b, ...d];
}
