/**
 * Lag of a physically simulated robot behind the plan: compares planned joint angles with those reached in a trial. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./editor-state.js').Trial} Trial
 *
 * @typedef {object} Worst largest lag of a joint
 * @property {number} degrees difference from the planned angle
 * @property {number} time milliseconds
 *
 * @typedef {object} Lag
 * @property {number} frameMillis time between two postures
 * @property {number[][]} planned
 * @property {number[][]} reached
 * @property {Array<Array<[number, number]>>} late intervals in which each joint lagged, milliseconds
 * @property {Worst[]} worst largest lag of each joint
 * @property {number} joint joint with the largest lag
 */
import { postureOfHinges } from './body.js';
import { postureAt } from './timing.js';

/** Lag in degrees above which a joint is marked. */
export const LATE_DEGREES = 5;

const TORSO_NUMBERS = 7;

/**
 * @param {Body} body
 * @param {readonly Keyframe[]} frames
 * @param {Trial} trial
 * @returns {Lag}
 */
export function lagOf(body, frames, trial) {
  const frameMillis = 1000 * trial.frameSeconds;
  const reached = trial.frames.map((frame) => postureOfHinges(body, frame.slice(TORSO_NUMBERS)));
  const planned = reached.map((_, i) => [...postureAt(frames, reached[0] ?? [], i * frameMillis)]);
  const worst = body.joints.map((_, joint) => worstOf(planned, reached, joint, frameMillis));
  const late = body.joints.map((_, joint) => lateOf(planned, reached, joint, frameMillis));
  const max = Math.max(...worst.map(({ degrees }) => degrees));
  return { frameMillis, planned, reached, late, worst, joint: worst.findIndex(({ degrees }) => degrees === max) };
}

/** @param {Lag} lag @param {number} time milliseconds @returns {number} index of the posture at this time */
export function lagFrame({ frameMillis, reached }, time) {
  return Math.max(0, Math.min(reached.length - 1, Math.round(time / frameMillis)));
}

/** @param {number[][]} planned @param {number[][]} reached @param {number} joint @param {number} frameMillis @returns {Worst} */
function worstOf(planned, reached, joint, frameMillis) {
  return reached.reduce(
    (worst, posture, i) => {
      const degrees = Math.abs(planned[i][joint] - posture[joint]);
      return degrees > worst.degrees ? { degrees, time: i * frameMillis } : worst;
    },
    { degrees: 0, time: 0 },
  );
}

/** @param {number[][]} planned @param {number[][]} reached @param {number} joint @param {number} frameMillis */
function lateOf(planned, reached, joint, frameMillis) {
  /** @type {Array<[number, number]>} */
  const parts = [];
  reached.forEach((posture, i) => {
    if (Math.abs(planned[i][joint] - posture[joint]) < LATE_DEGREES) {
      return;
    }
    const time = i * frameMillis;
    const last = parts.at(-1);
    if (last && last[1] === time) {
      last[1] = time + frameMillis;
    } else {
      parts.push([time, time + frameMillis]);
    }
  });
  return parts;
}
