/**
 * Checks whether a robot can perform a motion, and returns the findings as marks for the timeline. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 *
 * @typedef {object} Mark
 * @property {'speed' | 'collision' | 'range' | 'balance'} kind
 * @property {number} from milliseconds
 * @property {number} to milliseconds
 * @property {string} text explanation
 * @property {number} [joint] the joint concerned
 */
import { balanceOf } from './balance.js';
import { placed, posesOf } from './body.js';
import { collisionsOf } from './collisions.js';
import { jointName, linkName } from './names.js';
import { durationOf, postureAt, timesOf } from './timing.js';
import { numberText } from './motion-text.js';
import { CYCLE_MILLIS } from './motion-document.js';

const MAX_SAMPLES = 160;
const SPEED_TOLERANCE = 1.001;

/**
 * Marks joints that exceed the speed of their motors, and angles out of range. The transition to the first keyframe is not checked, because
 * the robot's posture before the motion is unknown.
 *
 * @param {Body} body
 * @param {readonly Keyframe[]} frames
 * @returns {Mark[]}
 */
export function jointMarks(body, frames) {
  const times = timesOf(frames);
  return frames.flatMap(({ millis, degrees }, i) => {
    const to = times[i];
    /** @type {Mark[]} */
    const marks = [];
    body.joints.forEach((joint, k) => {
      if (degrees[k] < joint.minDegrees || degrees[k] > joint.maxDegrees) {
        const text = `${jointName(joint.name)} at ${numberText(degrees[k])}° is beyond ${joint.minDegrees}° to ${joint.maxDegrees}°`;
        marks.push({ kind: 'range', from: to, to, text, joint: k });
      }
      const way = i === 0 ? 0 : Math.abs(degrees[k] - frames[i - 1].degrees[k]);
      if (way * 1000 > joint.maxDegreesPerSecond * Math.max(1, millis) * SPEED_TOLERANCE) {
        const neededMillis = Math.ceil((way / joint.maxDegreesPerSecond) * (1000 / CYCLE_MILLIS)) * CYCLE_MILLIS;
        const text = `${jointName(joint.name)} turns ${way.toFixed(0)}° in ${millis} ms; its motor needs ${neededMillis} ms`;
        marks.push({ kind: 'speed', from: to - millis, to, text, joint: k });
      }
    });
    return marks;
  });
}

/**
 * Samples the motion for self-collisions and for postures that are not statically balanced.
 *
 * @param {Body} body
 * @param {readonly Keyframe[]} frames
 * @param {'upright' | 'soles'} manner
 * @returns {Mark[]}
 */
export function bodyMarks(body, frames, manner) {
  if (frames.length === 0 || !body.isNao) {
    return [];
  }
  const step = Math.max(CYCLE_MILLIS, durationOf(frames) / MAX_SAMPLES);
  const first = frames[0].millis;
  /** @type {Mark[]} */
  const marks = [];
  for (let time = first; time <= durationOf(frames) + 1; time += step) {
    const posture = postureAt(frames, frames[0].degrees, time);
    const poses = posesOf(body, posture, placed(body, posture, manner));
    const touching = collisionsOf(body, poses).map((pair) => pair.map((link) => linkName(body.model.links[link].name)));
    if (touching.length > 0) {
      extend(marks, 'collision', time, step, `${touching[0].join(' runs into ')}`);
    }
    if (balanceOf(body, poses).margin < 0) {
      extend(
        marks,
        'balance',
        time,
        step,
        'The centre of mass is outside the support polygon: a robot that stands still would tip over',
      );
    }
  }
  return marks;
}

/**
 * @param {Mark[]} marks
 * @param {'collision' | 'balance'} kind
 * @param {number} time
 * @param {number} step
 * @param {string} text
 */
function extend(marks, kind, time, step, text) {
  const last = marks.findLast((mark) => mark.kind === kind);
  if (last && time - last.to < 1.5 * step) {
    last.to = time;
  } else {
    marks.push({ kind, from: time, to: time, text });
  }
}
