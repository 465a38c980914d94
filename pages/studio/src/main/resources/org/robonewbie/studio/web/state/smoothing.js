/**
 * Interpolation between frames: frames arrive 25 times per second, whereas pictures are drawn up to 60 times per second. The picture lags
 * by one frame interval. Pure.
 */

/**
 * @typedef {import('../live/state-frame.js').Frame} Frame
 * @typedef {import('../live/state-frame.js').RobotState} RobotState
 *
 * @typedef {object} Picture interpolated state
 * @property {Float32Array} ball
 * @property {RobotState[]} robots
 * @property {Float32Array[]} [things]
 */

/** Maximum interpolated movement between two frames in metres; a larger one is a jump. */
const JUMP_METRES = 0.4;

const MIN_MILLISECONDS = 15;
const MAX_MILLISECONDS = 120;

export class Smoothing {
  constructor() {
    /** @type {Picture | undefined} */
    this.from = undefined;
    /** @type {Frame | undefined} */
    this.to = undefined;
    this.arrived = 0;
    this.interval = 40;
  }

  /**
   * Adds a frame.
   *
   * @param {Frame} frame
   * @param {number} now milliseconds
   */
  push(frame, now) {
    this.from = this.to?.sceneRevision === frame.sceneRevision ? this.picture(now) : undefined;
    const waited = Math.max(MIN_MILLISECONDS, Math.min(MAX_MILLISECONDS, now - this.arrived));
    this.interval += 0.2 * (waited - this.interval);
    this.to = frame;
    this.arrived = now;
  }

  /** Discards all frames; the next one is drawn without interpolation. */
  clear() {
    this.from = undefined;
    this.to = undefined;
  }

  /**
   * Returns whether the picture is still changing without a new frame.
   *
   * @param {number} now milliseconds
   */
  isMoving(now) {
    return this.from !== undefined && now - this.arrived < this.interval + 20;
  }

  /**
   * Interpolates the picture.
   *
   * @param {number} now milliseconds
   * @returns {Picture | undefined}
   */
  picture(now) {
    const { from, to } = this;
    if (!from || !to) {
      return to;
    }
    const part = Math.max(0, Math.min(1, (now - this.arrived) / this.interval));
    if (part >= 1) {
      return to;
    }
    return {
      ball: blendPose(from.ball, to.ball, part),
      robots: to.robots.map((robot, i) => blendRobot(from.robots[i], robot, part)),
      things: to.things?.map((pose, i) => blendPose(from.things?.[i] ?? pose, pose, part)),
    };
  }
}

/**
 * @param {RobotState} from
 * @param {RobotState} to
 * @param {number} part
 */
function blendRobot(from, to, part) {
  if (hasJumped(from.torso, to.torso)) {
    return to;
  }
  const degrees = to.degrees.map((angle, i) => from.degrees[i] + part * (angle - from.degrees[i]));
  return { torso: blendPose(from.torso, to.torso, part), degrees };
}

/**
 * Interpolates two poses; the rotation takes the shorter path.
 *
 * @param {Float32Array} from
 * @param {Float32Array} to
 * @param {number} part interpolation parameter, from 0 to 1
 */
export function blendPose(from, to, part) {
  if (hasJumped(from, to)) {
    return to;
  }
  const dot = from[3] * to[3] + from[4] * to[4] + from[5] * to[5] + from[6] * to[6];
  const sign = dot < 0 ? -1 : 1;
  const pose = to.map((value, i) => {
    const start = i < 3 ? from[i] : sign * from[i];
    return start + part * (value - start);
  });
  const length = Math.hypot(pose[3], pose[4], pose[5], pose[6]);
  return pose.map((value, i) => (i < 3 ? value : value / length));
}

/**
 * Returns whether an object has been repositioned, for instance by a beam command, instead of moving there.
 *
 * @param {ArrayLike<number>} from its pose
 * @param {ArrayLike<number>} to
 */
export function hasJumped(from, to) {
  return Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]) > JUMP_METRES;
}
