/**
 * Detects self-collisions of a robot using the simulator's collision shapes: separating axes for boxes, distance to the inner segment for
 * spheres and capsules. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 */
import { POSE, rotated } from '../kinematics.js';

/** Limbs at most this many hinges apart always touch. */
const NEIGHBOUR_HINGES = 3;
const SLACK_METRES = 0.004;

/** @type {WeakMap<Body, number[][]>} */
const pairsOfBodies = new WeakMap();

/**
 * @param {Body} body
 * @param {Float64Array} poses
 * @returns {number[][]} pairs of links that overlap
 */
export function collisionsOf(body, poses) {
  const boxes = body.model.links.map((link, i) => ({
    centre: [0, 1, 2].map((axis) => poses[i * POSE + axis]),
    axes: [0, 1, 2].map((axis) => rotated(poses, i, [0, 0, 0].with(axis, 1))),
    half: link.size.map((edge) => Math.max(0.002, edge / 2 - SLACK_METRES)),
    radius: Math.max(0, (body.links[i].radius ?? 0) - SLACK_METRES),
    reach: (body.links[i].length ?? 0) / 2,
  }));
  return pairsOf(body).filter(([a, b]) => overlap(boxes[a], boxes[b]));
}

/** @param {Body} body */
function pairsOf(body) {
  const known = pairsOfBodies.get(body);
  if (known) {
    return known;
  }
  const pairs = [];
  for (let a = 0; a < body.links.length; a++) {
    for (let b = a + 1; b < body.links.length; b++) {
      if (body.links[a].solid && body.links[b].solid && hingesBetween(body, a, b) > NEIGHBOUR_HINGES) {
        pairs.push([a, b]);
      }
    }
  }
  pairsOfBodies.set(body, pairs);
  return pairs;
}

/** @param {Body} body @param {number} a @param {number} b */
function hingesBetween(body, a, b) {
  const [wayA, wayB] = [a, b].map((link) => ancestors(body, link));
  const shared = wayA.findIndex((link) => wayB.includes(link));
  return shared + wayB.indexOf(wayA[shared]);
}

/** @param {Body} body @param {number} link */
function ancestors(body, link) {
  const way = [link];
  for (let at = link; at !== 0; way.push(at)) {
    at = body.model.hinges.find(({ child }) => child === at)?.parent ?? 0;
  }
  return way;
}

/**
 * @typedef {object} Box
 * @property {number[]} centre
 * @property {number[][]} axes
 * @property {number[]} half
 * @property {number} radius radius of a sphere or capsule, otherwise 0
 * @property {number} reach half the length of a capsule's segment, along its last axis
 */

/** @param {Box} a @param {Box} b */
function overlap(a, b) {
  const between = b.centre.map((value, i) => value - a.centre[i]);
  if (Math.hypot(...between) > Math.hypot(...a.half) + Math.hypot(...b.half)) {
    return false;
  }
  if (a.radius > 0 || b.radius > 0) {
    return a.radius > 0 ? touchesRound(b, a) : touchesRound(a, b);
  }
  const edges = a.axes.flatMap((u) => b.axes.map((v) => crossed(u, v)));
  return [...a.axes, ...b.axes, ...edges].every((axis) => {
    const length = Math.hypot(...axis);
    return length < 1e-6 || Math.abs(dot(between, axis)) <= extent(a, axis) + extent(b, axis);
  });
}

/**
 * The distance from a point on a segment to a convex shape is convex, so ternary search finds the nearest one.
 *
 * @param {Box} shape
 * @param {Box} round
 */
function touchesRound(shape, round) {
  let [low, high] = [-round.reach, round.reach];
  while (high - low > 1e-4) {
    const third = (high - low) / 3;
    const isNearerLow = outside(shape, pointOn(round, low + third)) < outside(shape, pointOn(round, high - third));
    [low, high] = isNearerLow ? [low, high - third] : [low + third, high];
  }
  return outside(shape, pointOn(round, (low + high) / 2)) < round.radius;
}

/** @param {Box} round @param {number} along */
function pointOn({ centre, axes }, along) {
  return centre.map((value, i) => value + along * axes[2][i]);
}

/** @param {Box} shape @param {number[]} point @returns {number} metres from its surface, 0 inside */
function outside(shape, point) {
  const way = point.map((value, i) => value - shape.centre[i]);
  const places = shape.axes.map((axis) => dot(way, axis));
  if (shape.radius > 0) {
    const beyond = places[2] - Math.max(-shape.reach, Math.min(shape.reach, places[2]));
    return Math.max(0, Math.hypot(places[0], places[1], beyond) - shape.radius);
  }
  return Math.hypot(...places.map((place, i) => Math.max(0, Math.abs(place) - shape.half[i])));
}

/** @param {Box} box @param {number[]} axis */
function extent(box, axis) {
  return box.axes.reduce((sum, own, i) => sum + box.half[i] * Math.abs(dot(own, axis)), 0);
}

/** @param {number[]} a @param {number[]} b */
function dot(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** @param {number[]} a @param {number[]} b */
function crossed(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
