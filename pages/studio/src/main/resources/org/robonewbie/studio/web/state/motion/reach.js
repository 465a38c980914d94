/**
 * Inverse kinematics for dragged limbs, using a limb's own joints or those of the whole arm or leg. Damped least squares with a
 * finite-difference Jacobian. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./body.js').Posture} Posture
 *
 * @typedef {object} Pull
 * @property {number} link the pulled link
 * @property {number[]} local the point in the link's frame
 * @property {number[]} target target position in the world
 * @property {number[]} [up] target direction of the link's upward axis, for example of a sole
 * @property {number[]} joints joints that may turn
 */
import { rotated } from '../kinematics.js';
import { linkIndex, pointOf, posesOf } from './body.js';
import { clamped } from './posture.js';

const ROUNDS = 40;
const STEP_DEGREES = 0.5;
const MAX_DEGREES = 12;
const DAMPING = 2e-8;
const GOOD_METRES = 2e-4;
const STRIDE_METRES = 0.02;
const MAX_STRIDES = 25;
const STRIDE_DEGREES = 15;
const METRES_PER_UP = 0.12;
const LIMBS = /^(body|head|[lr](upperarm|lowerarm|thigh|shank|foot))$/;

/**
 * Returns the joints between a limb and the next limb inwards; for a robot other than the NAO, the one joint that turns the link.
 *
 * @param {Body} body
 * @param {number} link
 * @returns {number[]} indices of joints
 */
export function ownJoints(body, link) {
  return chain(body, link, (parent) => !body.isNao || LIMBS.test(body.model.links[parent].name));
}

/**
 * Returns the joints between a limb and the torso.
 *
 * @param {Body} body
 * @param {number} link
 * @returns {number[]} indices of joints
 */
export function chainJoints(body, link) {
  return chain(body, link, (parent) => parent === 0);
}

/** @param {Body} body @param {number} link @returns {number} the limb to which a small link inside a joint belongs */
export function limbOf(body, link) {
  let limb = link;
  while (body.isNao && !LIMBS.test(body.model.links[limb].name)) {
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
 * @param {ArrayLike<number>} torso fixed pose of the torso
 * @param {Pull} pull
 * @returns {number[]} the nearest posture within all joint ranges
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
 * Solves for the posture in small steps along a straight line to the target, so that a fast pointer does not make the joints flip.
 *
 * @param {Body} body
 * @param {Posture} posture
 * @param {ArrayLike<number>} torso fixed pose of the torso
 * @param {Pull} pull
 * @returns {number[]} the final posture
 */
export function followed(body, posture, torso, pull) {
  const from = pointOf(posesOf(body, posture, torso), pull.link, pull.local);
  const way = pull.target.map((value, axis) => value - from[axis]);
  const strides = Math.max(1, Math.min(MAX_STRIDES, Math.ceil(Math.hypot(...way) / STRIDE_METRES)));
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
 * Moves the torso while the feet stay in place.
 *
 * @param {Body} body
 * @param {Posture} posture
 * @param {number[]} torso pose
 * @param {number[]} way displacement in metres
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
 * @returns {number[]} residual in metres
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
 * Performs one iteration. A joint that is at its limit and would move beyond it is excluded, so that the others compensate.
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
      result[joint] = clamped(body, joint, posture[joint] + Math.max(-MAX_DEGREES, Math.min(MAX_DEGREES, turns[k])));
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
 * Solves a small linear system by Gaussian elimination with pivoting.
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
