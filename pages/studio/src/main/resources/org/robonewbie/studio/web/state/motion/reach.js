/**
 * Turns joints so that a point of the body comes to where it is pulled: with a limb's own joints, or by inverse kinematics
 * with the whole arm or leg. Damped least squares with a Jacobian by small differences. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./body.js').Posture} Posture
 *
 * @typedef {object} Pull
 * @property {number} link which is pulled
 * @property {number[]} local the point in the link's frame
 * @property {number[]} target where it shall be in the world
 * @property {number[]} [up] where the link's upward axis shall point, such as that of a sole
 * @property {number[]} joints which may turn
 */
import { rotated } from '../kinematics.js';
import { linkIndex, pointOf, posesOf } from './body.js';
import { clamped } from './posture.js';

const ROUNDS = 40;
const STEP_DEGREES = 0.5;
const MOST_DEGREES = 12;
const DAMPING = 2e-8;
const GOOD_METRES = 2e-4;
const STRIDE_METRES = 0.02;
const MOST_STRIDES = 25;
const STRIDE_DEGREES = 15;
const METRES_PER_UP = 0.12;
const LIMBS = /^(body|head|[lr](upperarm|lowerarm|thigh|shank|foot))$/;

/**
 * The joints between a limb and the next limb inwards.
 *
 * @param {Body} body
 * @param {number} link
 * @returns {number[]} indices of joints
 */
export function ownJoints(body, link) {
  return chain(body, link, (parent) => LIMBS.test(body.model.links[parent].name));
}

/**
 * The joints between a limb and the torso.
 *
 * @param {Body} body
 * @param {number} link
 * @returns {number[]} indices of joints
 */
export function chainJoints(body, link) {
  return chain(body, link, (parent) => parent === 0);
}

/** @param {Body} body @param {number} link @returns {number} the limb that stands for a small link inside of a joint */
export function limbOf(body, link) {
  let limb = link;
  while (!LIMBS.test(body.model.links[limb].name)) {
    limb = /** @type {{child: number}} */ (body.model.hinges.find(({ parent }) => parent === limb)).child;
  }
  return limb;
}

/**
 * @param {Body} body
 * @param {number} link
 * @param {(parent: number) => boolean} ends
 */
function chain(body, link, ends) {
  const joints = [];
  for (let at = link; at !== 0;) {
    const hinge = body.model.hinges.findIndex(({ child }) => child === at);
    const joint = body.jointOfHinge[hinge];
    if (!body.joints[joint].name.endsWith('HIP_YAW_PITCH')) {
      joints.push(joint);
    }
    at = body.model.hinges[hinge].parent;
    if (ends(at)) {
      break;
    }
  }
  return joints;
}

/**
 * @param {Body} body
 * @param {Posture} posture
 * @param {ArrayLike<number>} torso pose of the torso, which stays
 * @param {Pull} pull
 * @returns {number[]} the posture that comes nearest, within all ranges
 */
export function pulled(body, posture, torso, pull) {
  let best = [...posture];
  let error = errorOf(body, best, torso, pull);
  let damping = DAMPING;
  for (let round = 0; round < ROUNDS && Math.hypot(...error) > GOOD_METRES; round++) {
    const tried = improved(body, best, torso, pull, error, damping);
    const triedError = errorOf(body, tried, torso, pull);
    if (Math.hypot(...triedError) < Math.hypot(...error)) {
      best = tried;
      error = triedError;
      damping = Math.max(DAMPING, damping / 4);
    } else {
      damping *= 10;
    }
  }
  return best;
}

/**
 * Pulls in small strides along the straight way, so that a hand that jumps far does not make the joints snap over.
 *
 * @param {Body} body
 * @param {Posture} posture
 * @param {ArrayLike<number>} torso pose of the torso, which stays
 * @param {Pull} pull
 * @returns {number[]} the posture at the end of the way
 */
export function followed(body, posture, torso, pull) {
  const from = pointOf(posesOf(body, posture, torso), pull.link, pull.local);
  const way = pull.target.map((value, axis) => value - from[axis]);
  const strides = Math.max(1, Math.min(MOST_STRIDES, Math.ceil(Math.hypot(...way) / STRIDE_METRES)));
  let reached = [...posture];
  for (let stride = 1; stride <= strides; stride++) {
    const before = reached;
    const target = from.map((value, axis) => value + (way[axis] * stride) / strides);
    const next = pulled(body, before, torso, { ...pull, target });
    reached = next.map(
      (angle, i) => before[i] + Math.max(-STRIDE_DEGREES, Math.min(STRIDE_DEGREES, angle - before[i])),
    );
  }
  return reached;
}

/**
 * Moves the torso while the feet stay where they are.
 *
 * @param {Body} body
 * @param {Posture} posture
 * @param {number[]} torso pose
 * @param {number[]} way metres
 * @returns {{posture: number[], torso: number[]}}
 */
export function torsoMoved(body, posture, torso, way) {
  const moved = torso.map((value, i) => value + (way[i] ?? 0));
  const before = posesOf(body, posture, torso);
  let result = [...posture];
  for (const name of ['lfoot', 'rfoot']) {
    const link = linkIndex(body, name);
    const target = pointOf(before, link, [0, 0, 0]);
    const up = rotated(before, link, [0, 0, 1]);
    result = pulled(body, result, moved, { link, local: [0, 0, 0], target, up, joints: chainJoints(body, link) });
  }
  return { posture: result, torso: moved };
}

/**
 * @param {Body} body
 * @param {Posture} posture
 * @param {ArrayLike<number>} torso
 * @param {Pull} pull
 * @returns {number[]} what is still missing, in metres
 */
function errorOf(body, posture, torso, { link, local, target, up }) {
  const poses = posesOf(body, posture, torso);
  const missing = pointOf(poses, link, local).map((value, axis) => target[axis] - value);
  if (up) {
    rotated(poses, link, [0, 0, 1]).forEach((value, axis) => missing.push(METRES_PER_UP * (up[axis] - value)));
  }
  return missing;
}

/**
 * One step. A joint that is at the end of its range and would have to go on is left out, so that the others do its part.
 *
 * @param {Body} body
 * @param {number[]} posture
 * @param {ArrayLike<number>} torso
 * @param {Pull} pull
 * @param {number[]} error
 * @param {number} damping
 */
function improved(body, posture, torso, pull, error, damping) {
  const columns = pull.joints.map((joint) => {
    const nudged = posture.with(joint, posture[joint] + STEP_DEGREES);
    return errorOf(body, nudged, torso, pull).map((value, row) => (error[row] - value) / STEP_DEGREES);
  });
  let free = pull.joints.map((_, i) => i);
  for (;;) {
    const result = [...posture];
    const turns = leastSquares(
      free.map((i) => columns[i]),
      error,
      damping,
    );
    free.forEach((i, k) => {
      const joint = pull.joints[i];
      result[joint] = clamped(body, joint, posture[joint] + Math.max(-MOST_DEGREES, Math.min(MOST_DEGREES, turns[k])));
    });
    const stuck = free.filter(
      (i, k) => result[pull.joints[i]] === posture[pull.joints[i]] && Math.abs(turns[k]) > 1e-9,
    );
    if (stuck.length === 0 || stuck.length === free.length) {
      return result;
    }
    free = free.filter((i) => !stuck.includes(i));
  }
}

/** @param {number[][]} columns @param {number[]} error @param {number} damping */
function leastSquares(columns, error, damping) {
  const matrix = columns.map((a, i) => columns.map((b, j) => dot(a, b) + (i === j ? damping : 0)));
  return solved(
    matrix,
    columns.map((column) => dot(column, error)),
  );
}

/** @param {number[]} a @param {number[]} b */
function dot(a, b) {
  return a.reduce((sum, value, i) => sum + value * b[i], 0);
}

/**
 * Gauss with pivots for a small matrix.
 *
 * @param {number[][]} matrix
 * @param {number[]} right
 */
function solved(matrix, right) {
  const rows = matrix.map((row, i) => [...row, right[i]]);
  const size = rows.length;
  for (let i = 0; i < size; i++) {
    const pivot = rows.reduce((best, row, k) => (k >= i && Math.abs(row[i]) > Math.abs(rows[best][i]) ? k : best), i);
    [rows[i], rows[pivot]] = [rows[pivot], rows[i]];
    for (let k = i + 1; k < size; k++) {
      const factor = rows[k][i] / rows[i][i];
      rows[k] = rows[k].map((value, column) => value - factor * rows[i][column]);
    }
  }
  const result = new Array(size).fill(0);
  for (let i = size - 1; i >= 0; i--) {
    const known = result.reduce((sum, value, k) => (k > i ? sum + rows[i][k] * value : sum), 0);
    result[i] = (rows[i][size] - known) / rows[i][i];
  }
  return result;
}
