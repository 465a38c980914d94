/** Says in the picture why a limb does not follow the hand that drags it. */
import { element, setText } from '../panels/elements.js';
import { jointName } from '../state/motion/names.js';

/** @typedef {import('../state/motion/body.js').Body} Body */

const STUCK_METRES = 0.03;
const AT_LIMIT_DEGREES = 0.1;

/**
 * @param {HTMLElement} place the picture
 * @param {Body} body
 * @returns {(joint: number | undefined) => void} shows which joint is at its limit, or nothing
 */
export function limitSign(place, body) {
  const sign = element('p', { class: 'panel limit-sign', role: 'status', hidden: '' });
  place.append(sign);
  return (joint) => {
    sign.hidden = joint === undefined;
    if (joint !== undefined) {
      setText(sign, `The ${jointName(body.joints[joint].name)} is at its limit.`);
    }
  };
}

/** @param {readonly number[]} target @param {readonly number[]} point @returns {number} metres */
export function farFrom(target, point) {
  return Math.hypot(...target.map((value, i) => value - point[i]));
}

/**
 * @param {Body} body
 * @param {readonly number[]} posture
 * @param {readonly number[]} joints that may turn
 * @param {number} metres how far the limb is from where the hand is
 * @returns {number | undefined} the joint that keeps the limb from following
 */
export function stuckJoint(body, posture, joints, metres) {
  const isAtLimit = (/** @type {number} */ joint) => {
    const { minDegrees, maxDegrees } = body.joints[joint];
    return posture[joint] < minDegrees + AT_LIMIT_DEGREES || posture[joint] > maxDegrees - AT_LIMIT_DEGREES;
  };
  return metres < STUCK_METRES ? undefined : joints.find(isAtLimit);
}
