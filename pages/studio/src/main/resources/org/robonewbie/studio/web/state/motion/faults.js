/**
 * Faults of a motion at one moment, with the affected links. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./lag.js').Lag} Lag
 *
 * @typedef {object} Fault
 * @property {'speed' | 'range' | 'limit' | 'collision' | 'lag' | 'fastest'} kind
 * @property {string} text explanation
 * @property {number[]} links affected
 */
import { collisionsOf } from './collisions.js';
import { LATE_DEGREES, lagFrame } from './lag.js';
import { numberText } from './motion-text.js';
import { jointName, linkName } from './names.js';
import { limbOf } from './reach.js';
import { keyframeAt } from './timing.js';

const AT_LIMIT_DEGREES = 0.05;
const MAX_LATE = 3;
const SPEED_TOLERANCE = 1.001;

/**
 * @param {Body} body
 * @param {readonly Keyframe[]} frames
 * @param {number} time milliseconds
 * @param {readonly number[]} posture posture at this time
 * @param {Float64Array} poses poses of its links
 * @returns {Fault[]}
 */
export function faultsAt(body, frames, time, posture, poses) {
  return [
    ...speedFaults(body, frames, time),
    ...body.joints.flatMap((_, joint) => limitFault(body, joint, posture[joint])),
    ...collisionFaults(body, poses),
  ];
}

/**
 * Returns how far the joints of a physically simulated robot lag behind the plan at a moment.
 *
 * @param {Body} body
 * @param {Lag} lag
 * @param {number} time milliseconds
 * @returns {Fault[]} the largest lag first
 */
export function lagFaults(body, lag, time) {
  const frame = lagFrame(lag, time);
  return body.joints
    .map((_, joint) => ({ joint, degrees: lag.planned[frame][joint] - lag.reached[frame][joint] }))
    .filter(({ degrees }) => Math.abs(degrees) >= LATE_DEGREES)
    .sort((a, b) => Math.abs(b.degrees) - Math.abs(a.degrees))
    .slice(0, MAX_LATE)
    .map(({ joint, degrees }) => ({
      kind: 'lag',
      text: `${jointName(body.joints[joint].name)} is ${Math.abs(degrees).toFixed(0)}° off the plan`,
      links: [linkOf(body, joint)],
    }));
}

/** @param {Body} body @param {number} joint @returns {number} the link that a joint turns */
export function linkOf(body, joint) {
  const hinge = body.jointOfHinge.indexOf(joint);
  return limbOf(body, body.model.hinges[hinge].child);
}

/**
 * Returns the speed faults. The transition to the first keyframe is not checked, because the robot's posture before the motion is unknown.
 *
 * @param {Body} body
 * @param {readonly Keyframe[]} frames
 * @param {number} time
 * @returns {Fault[]}
 */
function speedFaults(body, frames, time) {
  const at = keyframeAt(frames, time);
  if (at < 1) {
    return [];
  }
  const speeds = body.joints.map(({ maxDegreesPerSecond }, joint) => {
    const way = Math.abs(frames[at].degrees[joint] - frames[at - 1].degrees[joint]);
    const perSecond = (1000 * way) / Math.max(1, frames[at].millis);
    return { joint, perSecond, share: perSecond / maxDegreesPerSecond };
  });
  const tooFast = speeds.filter(({ share }) => share > SPEED_TOLERANCE);
  const fastest = speeds.reduce((best, each) => (each.share > best.share ? each : best));
  const shown = tooFast.length > 0 || fastest.share === 0 ? tooFast : [fastest];
  return shown.map((each) => ({
    kind: tooFast.length > 0 ? 'speed' : 'fastest',
    text: speedText(body, each),
    links: tooFast.length > 0 ? [linkOf(body, each.joint)] : [],
  }));
}

/** @param {Body} body @param {{joint: number, perSecond: number, share: number}} speed */
function speedText({ joints }, { joint, perSecond, share }) {
  const { name, maxDegreesPerSecond } = joints[joint];
  const can = `${maxDegreesPerSecond.toFixed(0)}°/s that its motor can reach`;
  return share > SPEED_TOLERANCE
    ? `${jointName(name)} would turn at ${perSecond.toFixed(0)}°/s, more than the ${can}`
    : `fastest: ${jointName(name)} at ${perSecond.toFixed(0)} of the ${can}`;
}

/** @param {Body} body @param {number} joint @param {number} degrees @returns {Fault[]} */
function limitFault(body, joint, degrees) {
  const { name, minDegrees, maxDegrees } = body.joints[joint];
  const links = [linkOf(body, joint)];
  const range = `${minDegrees}° to ${maxDegrees}°`;
  if (degrees < minDegrees || degrees > maxDegrees) {
    return [{ kind: 'range', text: `${jointName(name)} at ${numberText(tenth(degrees))}° is beyond ${range}`, links }];
  }
  const isAtLimit = Math.min(degrees - minDegrees, maxDegrees - degrees) < AT_LIMIT_DEGREES;
  return isAtLimit ? [{ kind: 'limit', text: `${jointName(name)} is at its limit, ${range}`, links }] : [];
}

/** @param {Body} body @param {Float64Array} poses @returns {Fault[]} */
function collisionFaults(body, poses) {
  return collisionsOf(body, poses).map((links) => ({
    kind: 'collision',
    text: links.map((link) => linkName(body.model.links[link].name)).join(' runs into '),
    links,
  }));
}

/** @param {number} degrees */
function tenth(degrees) {
  return Math.round(10 * degrees) / 10;
}
