/**
 * Robot model of the motion editor: joints in the order of the motion files, and forward kinematics of postures. Pure.
 *
 * @typedef {import('../kinematics.js').RobotModel} RobotModel
 *
 * @typedef {object} JointFacts
 * @property {string} name name such as LEFT_KNEE_PITCH
 * @property {number} minDegrees
 * @property {number} maxDegrees
 * @property {number} maxDegreesPerSecond infinite for a motor without a limit of speed
 * @property {number} partner index of the joint on the other side, or of itself; the latter if it is not known
 * @property {number} mirrorSign factor of the angle when mirrored
 *
 * @typedef {object} BodyLink
 * @property {number} massKg
 * @property {boolean} solid whether it can collide
 * @property {number} [radius] radius of a sphere or capsule, metres; other links are boxes
 * @property {number} [length] distance along z between the two hemispheres of a capsule, metres
 *
 * @typedef {object} Body
 * @property {string} robot name of the robot
 * @property {boolean} isNao whether it is the NAO, for which alone mirroring, balance, collisions and trials are known
 * @property {JointFacts[]} joints
 * @property {RobotModel} model
 * @property {BodyLink[]} links
 * @property {number[]} jointOfHinge joint index of each hinge of the model
 *
 * @typedef {readonly number[]} Posture one angle in degrees for each joint
 */
import { isNao } from '../figure.js';
import { computeLinkPoses, POSE, rotated } from '../kinematics.js';
import { NAO } from './motion-text.js';

const SOLE_HEIGHT = 0.01;
const EVEN_METRES = 0.006;

/**
 * @typedef {Partial<JointFacts> & Pick<JointFacts, 'name' | 'minDegrees' | 'maxDegrees'>} KnownFacts
 *
 * @param {{joints: KnownFacts[], model: RobotModel, links?: BodyLink[]}} description description from the studio's server
 * @returns {Body}
 */
export function bodyOf({ joints: known, model, links }) {
  const joints = known.map((joint, i) => ({ maxDegreesPerSecond: Infinity, partner: i, mirrorSign: 1, ...joint }));
  return {
    robot: model.name ?? NAO,
    isNao: isNao(model),
    joints,
    model,
    links: links ?? model.links.map(() => ({ massKg: 0, solid: false })),
    jointOfHinge: model.hinges.map(({ joint }) => joints.findIndex(({ name }) => name === joint)),
  };
}

/**
 * @param {Body} body
 * @param {Posture} posture
 * @returns {number[]} the same angles in the order of the model's hinges
 */
export function hingeDegrees(body, posture) {
  return body.jointOfHinge.map((joint) => posture[joint]);
}

/**
 * @param {Body} body
 * @param {ArrayLike<number>} degrees angles in the order of the model's hinges
 * @returns {number[]} the same angles in the order of the motion files
 */
export function postureOfHinges(body, degrees) {
  const posture = new Array(body.joints.length).fill(0);
  body.jointOfHinge.forEach((joint, hinge) => {
    if (joint >= 0) {
      posture[joint] = Math.round(degrees[hinge] * 100) / 100;
    }
  });
  return posture;
}

/**
 * @param {Body} body
 * @param {Posture} posture
 * @param {ArrayLike<number>} torso its pose, seven numbers
 * @returns {Float64Array} poses of all links
 */
export function posesOf(body, posture, torso) {
  const poses = new Float64Array(body.model.links.length * POSE);
  computeLinkPoses(body.model, torso, hingeDegrees(body, posture), poses);
  return poses;
}

/** @param {Body} body @param {string} name */
export function linkIndex(body, name) {
  return body.model.links.findIndex((link) => link.name === name);
}

/**
 * Places the robot on the ground: with an upright torso, or with the lower sole flat on the ground. A robot other than the NAO is always
 * upright.
 *
 * @param {Body} body
 * @param {Posture} posture
 * @param {'upright' | 'soles'} manner
 * @returns {number[]} pose of the torso
 */
export function placed(body, posture, manner) {
  const upright = [0, 0, 0, 1, 0, 0, 0];
  if (!body.isNao) {
    return upright.with(2, -lowest(body, posesOf(body, posture, upright)));
  }
  const rotation = manner === 'upright' ? [1, 0, 0, 0] : fromSole(body, posesOf(body, posture, upright));
  const poses = posesOf(body, posture, [0, 0, 0, ...rotation]);
  const [x, y] = middleOfFeet(body, poses);
  return [-x, -y, -lowest(body, poses), ...rotation];
}

/**
 * @param {Body} body
 * @param {Float64Array} poses
 * @returns {number} height of the lowest point of the solid links
 */
export function lowest(body, poses) {
  let bottom = Infinity;
  body.model.links.forEach((link, i) => {
    const corners = body.links[i].solid ? cornersOf(link.size, poses, i) : cornersOfShapes(link.shapes ?? [], poses, i);
    bottom = Math.min(bottom, ...corners.map((corner) => corner[2]));
  });
  return bottom;
}

/**
 * @param {number[]} size
 * @param {ArrayLike<number>} poses
 * @param {number} link
 * @returns {number[][]} the eight corners of its box
 */
export function cornersOf(size, poses, link) {
  const corners = [];
  for (let i = 0; i < 8; i++) {
    const local = size.map((edge, axis) => ((i >> axis) & 1 ? edge : -edge) / 2);
    corners.push(pointOf(poses, link, local));
  }
  return corners;
}

/**
 * @param {import('../kinematics.js').Shape[]} shapes
 * @param {ArrayLike<number>} poses
 * @param {number} link
 */
function cornersOfShapes(shapes, poses, link) {
  return shapes.flatMap(({ size, position, rotation }) =>
    cornersOf(size, [...position, ...rotation], 0).map((corner) => pointOf(poses, link, corner)),
  );
}

/**
 * @param {ArrayLike<number>} poses
 * @param {number} link
 * @param {number[]} local a point in the link's frame
 * @returns {number[]} the point in the world
 */
export function pointOf(poses, link, local) {
  const turned = rotated(poses, link, local);
  return turned.map((value, axis) => value + poses[link * POSE + axis]);
}

/**
 * @param {Body} body
 * @param {Float64Array} poses
 * @returns {number[]} centre of mass in metres
 */
export function centreOfMass(body, poses) {
  const sum = [0, 0, 0];
  let mass = 0;
  body.links.forEach(({ massKg }, i) => {
    mass += massKg;
    sum.forEach((_, axis) => {
      sum[axis] += massKg * poses[i * POSE + axis];
    });
  });
  return sum.map((value) => value / mass);
}

/** @param {Body} body @param {Float64Array} poses */
function middleOfFeet(body, poses) {
  const feet = ['lfoot', 'rfoot'].map((name) => linkIndex(body, name) * POSE);
  return [0, 1].map((axis) => (poses[feet[0] + axis] + poses[feet[1] + axis]) / 2);
}

/**
 * Returns the rotation that places the lower sole flat on the ground, or both soles if they are equally low.
 *
 * @param {Body} body
 * @param {Float64Array} poses poses with an upright torso
 * @returns {number[]} quaternion
 */
function fromSole(body, poses) {
  const soles = ['lfoot', 'rfoot'].map((name) => {
    const link = linkIndex(body, name);
    return { height: pointOf(poses, link, [0, 0, -SOLE_HEIGHT])[2], up: rotated(poses, link, [0, 0, 1]) };
  });
  const [left, right] = soles;
  const difference = left.height - right.height;
  const part = Math.max(0, Math.min(1, 0.5 - difference / (2 * EVEN_METRES)));
  const up = left.up.map((value, axis) => part * value + (1 - part) * right.up[axis]);
  return shortestArc(up, [0, 0, 1]);
}

/**
 * @param {number[]} from
 * @param {number[]} to a unit vector
 * @returns {number[]} quaternion w, x, y, z
 */
function shortestArc(from, to) {
  const length = Math.hypot(...from) || 1;
  const [a, b, c] = from.map((value) => value / length);
  const w = 1 + a * to[0] + b * to[1] + c * to[2];
  if (w < 1e-6) {
    return [0, 1, 0, 0];
  }
  const q = [w, b * to[2] - c * to[1], c * to[0] - a * to[2], a * to[1] - b * to[0]];
  const norm = Math.hypot(...q);
  return q.map((value) => value / norm);
}
