/** Reads the binary state frames of the live feed; the Java class StateFrame documents the format. */

/**
 * @typedef {object} RobotState
 * @property {Float32Array} torso position x, y, z in metres and rotation w, x, y, z
 * @property {Float32Array} degrees angle of each hinge
 *
 * @typedef {object} Frame
 * @property {boolean} paused
 * @property {number} sceneRevision
 * @property {number} cycle
 * @property {number} gameTime seconds
 * @property {number} speed requested simulated seconds per second of real time; Infinity = as fast as possible
 * @property {number} realTimeFactor measured simulated seconds per second of real time
 * @property {number} playMode index in the scene's list
 * @property {number} scoreLeft
 * @property {number} scoreRight
 * @property {number} half
 * @property {Float32Array} ball pose, seven numbers
 * @property {RobotState[]} robots
 * @property {Float32Array[]} [things] poses of the other objects on the pitch
 *
 * @typedef {import('../state/kinematics.js').RobotModel} RobotModel
 *
 * @typedef {object} Player
 * @property {number} id
 * @property {string} team
 * @property {'left'|'right'|''} side
 * @property {number} number
 * @property {string} type
 * @property {boolean} [puppet] whether the user controls it manually
 *
 * @typedef {object} Field
 * @property {number} length
 * @property {number} width
 * @property {number} goalWidth
 * @property {number} goalDepth
 * @property {number} goalHeight
 * @property {number} penaltyLength
 * @property {number} penaltyWidth
 * @property {number} centreCircleRadius
 *
 * @typedef {object} Thing
 * @property {string} name
 * @property {[number, number, number]} size metres
 * @property {boolean} movable
 *
 * @typedef {object} Scene
 * @property {number} revision
 * @property {Field} field
 * @property {{left: string, right: string}} teams
 * @property {Player[]} robots
 * @property {Thing[]} [things] other objects on the pitch
 * @property {Object<string, RobotModel>} models models by robot type
 * @property {string[]} playModes
 * @property {number} [agentPort] port for agents, if they can join
 * @property {boolean} [clock] whether the clock can be paused
 * @property {boolean} [match] whether play mode, score and time can be set
 * @property {Details} [details] ball and markings where they differ from SimSpark's
 * @property {boolean} [puppets] whether manually controlled robots can join
 * @property {Trial} [trial] the running trial of an exercise, if any
 *
 * @typedef {object} Details
 * @property {number} ballRadius metres
 * @property {number} goalAreaLength metres, 0 for no goal area
 * @property {number} goalAreaWidth
 * @property {number} penaltySpotDistance metres from the goal line, 0 for no spot
 *
 * @typedef {{task: string, attempt: number, seed: number}} Trial trials with the same task and seed start identically
 */

const VERSION = 1;
const HEADER_BYTES = 24;
const POSE_BYTES = 20;
const UNIT_ROTATION = 32767;
const STEPS_PER_DEGREE = 100;

/**
 * @param {ArrayBuffer} bytes encoded frame
 * @param {Scene} scene the current scene
 * @returns {Frame | undefined} the state, or undefined if the frame belongs to another scene
 * @throws {Error} if the studio's protocol version differs from this page's
 */
export function readFrame(bytes, scene) {
  const view = new DataView(bytes);
  if (view.getUint8(0) !== VERSION) {
    throw new Error('The studio is newer than this page. Reload the page.');
  }
  if (view.getUint16(2, true) !== scene.revision) {
    return undefined;
  }
  let at = HEADER_BYTES + POSE_BYTES;
  const robots = scene.robots.map((player) => {
    const hinges = scene.models[player.type].hinges.length;
    const robot = { torso: readPose(view, at), degrees: readDegrees(view, at + POSE_BYTES, hinges) };
    at += POSE_BYTES + 2 * hinges;
    return robot;
  });
  const things = (scene.things ?? []).map((_, i) => readPose(view, at + i * POSE_BYTES));
  return {
    paused: (view.getUint8(1) & 1) !== 0,
    sceneRevision: scene.revision,
    cycle: view.getUint32(4, true),
    gameTime: view.getFloat32(8, true),
    speed: view.getFloat32(12, true),
    realTimeFactor: view.getFloat32(16, true),
    playMode: view.getUint8(20),
    scoreLeft: view.getUint8(21),
    scoreRight: view.getUint8(22),
    half: view.getUint8(23),
    ball: readPose(view, HEADER_BYTES),
    robots,
    things,
  };
}

/**
 * @param {DataView} view
 * @param {number} at
 */
function readPose(view, at) {
  const pose = new Float32Array(7);
  for (let i = 0; i < 3; i++) {
    pose[i] = view.getFloat32(at + 4 * i, true);
  }
  for (let i = 0; i < 4; i++) {
    pose[3 + i] = view.getInt16(at + 12 + 2 * i, true) / UNIT_ROTATION;
  }
  return pose;
}

/**
 * @param {DataView} view
 * @param {number} at
 * @param {number} count
 */
function readDegrees(view, at, count) {
  const degrees = new Float32Array(count);
  for (let i = 0; i < count; i++) {
    degrees[i] = view.getInt16(at + 2 * i, true) / STEPS_PER_DEGREE;
  }
  return degrees;
}
