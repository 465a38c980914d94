/**
 * Forward kinematics: poses of all links from the torso's pose and the joint angles. Pure: no three.js, no page.
 *
 * Poses are seven numbers each: position x, y, z in metres and rotation w, x, y, z as a unit quaternion.
 */

/**
 * @typedef {object} Link
 * @property {string} name
 * @property {number[]} position centre in the construction pose, relative to the torso's centre, metres
 * @property {number[]} size
 * @property {Shape[]} [shapes] shapes to draw; absent for the NAO, which has a dedicated design
 *
 * @typedef {object} Shape
 * @property {'box' | 'sphere' | 'capsule'} kind a capsule lies along its z axis
 * @property {number[]} size size of its bounding box
 * @property {number[]} position centre in the link's frame
 * @property {number[]} rotation quaternion w, x, y, z
 *
 * @typedef {object} Hinge
 * @property {string} joint
 * @property {number} child index of the outer link
 * @property {number} parent index of the inner link
 * @property {number[]} anchor a point on the axis in the construction pose
 * @property {number[]} axis
 * @property {number} minDegrees
 * @property {number} maxDegrees
 * @property {string} effector name of the effector in messages
 * @property {number} [stanceDegrees] angle in the stance; absent for the NAO
 * @property {number} maxSpeed maximum speed of its motor, degrees per second; absent for a motor without a limit of speed
 *
 * @typedef {object} RobotModel
 * @property {string} [name] name of the model; absent for the NAO
 * @property {number} [stanceHeight] height of the torso in the stance, metres; 0 if it is not known
 * @property {Link[]} links links, the torso first
 * @property {Hinge[]} hinges hinges, parents before children
 */

const HALF_RADIANS_PER_DEGREE = Math.PI / 360;

/** Numbers per pose. */
export const POSE = 7;

/**
 * Computes the pose of every link.
 *
 * @param {RobotModel} model the robot's body
 * @param {ArrayLike<number>} torso pose of the torso, seven numbers
 * @param {ArrayLike<number>} degrees angle of each hinge
 * @param {Float32Array | Float64Array} poses receives seven numbers per link
 */
export function computeLinkPoses(model, torso, degrees, poses) {
  for (let i = 0; i < POSE; i++) {
    poses[i] = torso[i];
  }
  model.hinges.forEach((hinge, i) => {
    const parent = hinge.parent * POSE;
    const child = hinge.child * POSE;
    const toAnchor = difference(hinge.anchor, model.links[hinge.parent].position);
    const toChild = difference(model.links[hinge.child].position, hinge.anchor);
    copyPosition(poses, parent, child);
    addRotated(poses, parent, toAnchor, child);
    turn(poses, parent, hinge.axis, degrees[i], child);
    addRotated(poses, child, toChild, child);
  });
}

/**
 * Rotates a vector from a link's frame into the world frame.
 *
 * @param {ArrayLike<number>} poses poses of all links
 * @param {number} link index of the link
 * @param {number[]} vector x, y, z in the link's frame
 * @returns {number[]} x, y, z in the world frame
 */
export function rotated(poses, link, vector) {
  const at = link * POSE;
  const [w, x, y, z] = [poses[at + 3], poses[at + 4], poses[at + 5], poses[at + 6]];
  const tx = 2 * (y * vector[2] - z * vector[1]);
  const ty = 2 * (z * vector[0] - x * vector[2]);
  const tz = 2 * (x * vector[1] - y * vector[0]);
  return [
    vector[0] + w * tx + y * tz - z * ty,
    vector[1] + w * ty + z * tx - x * tz,
    vector[2] + w * tz + x * ty - y * tx,
  ];
}

/**
 * Returns the heading of a robot.
 *
 * @param {ArrayLike<number>} torso pose of its torso
 * @returns {number} degrees, 0 along x towards the right goal, counter-clockwise
 */
export function headingDegrees(torso) {
  const forward = rotated(torso, 0, [0, 1, 0]);
  return (Math.atan2(forward[1], forward[0]) * 180) / Math.PI;
}

/**
 * Returns the height of the torso of a robot that stands upright with the given joint angles.
 *
 * @param {RobotModel} model the robot's body
 * @param {ArrayLike<number>} degrees its joint angles
 * @returns {number} height of the torso's centre above the ground in metres
 */
export function standingHeight(model, degrees) {
  const poses = new Float32Array(model.links.length * POSE);
  computeLinkPoses(model, [0, 0, 0, 1, 0, 0, 0], degrees, poses);
  const lowest = model.links.map((link, i) => poses[i * POSE + 2] - halfHeight(link, poses, i));
  return -Math.min(...lowest);
}

/**
 * @param {Link} link
 * @param {ArrayLike<number>} poses
 * @param {number} index
 */
function halfHeight(link, poses, index) {
  const [x, y, z] = [0, 1, 2].map((axis) => {
    const unit = [0, 0, 0];
    unit[axis] = link.size[axis] / 2;
    return Math.abs(rotated(poses, index, unit)[2]);
  });
  return x + y + z;
}

/**
 * @param {number[]} a
 * @param {number[]} b
 */
function difference(a, b) {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

/**
 * @param {Float32Array | Float64Array} poses
 * @param {number} from
 * @param {number} to
 */
function copyPosition(poses, from, to) {
  poses[to] = poses[from];
  poses[to + 1] = poses[from + 1];
  poses[to + 2] = poses[from + 2];
}

/**
 * Translates one pose by a vector given in the frame of another.
 *
 * @param {Float32Array | Float64Array} poses
 * @param {number} frame
 * @param {number[]} vector
 * @param {number} moved
 */
function addRotated(poses, frame, vector, moved) {
  const [x, y, z] = rotated(poses, frame / POSE, vector);
  poses[moved] += x;
  poses[moved + 1] += y;
  poses[moved + 2] += z;
}

/**
 * @param {Float32Array | Float64Array} poses
 * @param {number} parent
 * @param {number[]} axis
 * @param {number} degrees
 * @param {number} child
 */
function turn(poses, parent, axis, degrees, child) {
  const half = degrees * HALF_RADIANS_PER_DEGREE;
  const sine = Math.sin(half);
  const [bw, bx, by, bz] = [Math.cos(half), axis[0] * sine, axis[1] * sine, axis[2] * sine];
  const [aw, ax, ay, az] = [poses[parent + 3], poses[parent + 4], poses[parent + 5], poses[parent + 6]];
  poses[child + 3] = aw * bw - ax * bx - ay * by - az * bz;
  poses[child + 4] = aw * bx + ax * bw + ay * bz - az * by;
  poses[child + 5] = aw * by - ax * bz + ay * bw + az * bx;
  poses[child + 6] = aw * bz + ax * by - ay * bx + az * bw;
}
