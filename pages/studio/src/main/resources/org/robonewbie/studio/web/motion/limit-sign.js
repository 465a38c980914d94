/** Shows which joint limit stops a dragged limb, in an overlay on the motion editor's 3D view. */
import { element, setText } from '../panels/elements.js';
import { jointName } from '../state/motion/names.js';

/** @typedef {import('../state/motion/body.js').Body} Body */

const STUCK_METRES = 0.03;
const AT_LIMIT_DEGREES = 0.1;

/**
 * @param {HTMLElement} place container of the 3D view
 * @param {() => Body} bodyNow the robot that is shown
 * @returns {(joint: number | undefined) => void} function that shows the joint at its limit, or hides the sign
 */
export function limitSign(place, bodyNow) {
  const sign = element('p', { class: 'panel centred limit-sign', role: 'status', hidden: '' });
  place.append(sign);
  return (joint) => {
    sign.hidden = joint === undefined;
    if (joint !== undefined) {
      setText(sign, `The ${jointName(bodyNow().joints[joint].name)} is at its limit.`);
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
 * @param {readonly number[]} joints joints that the drag can turn
 * @param {number} metres distance between the limb and the pointer
 * @returns {number | undefined} the joint that blocks the limb
 */
export function stuckJoint(body, posture, joints, metres) {
  const isAtLimit = (/** @type {number} */ joint) => {
    const { minDegrees, maxDegrees } = body.joints[joint];
    return posture[joint] < minDegrees + AT_LIMIT_DEGREES || posture[joint] > maxDegrees - AT_LIMIT_DEGREES;
  };
  return metres < STUCK_METRES ? undefined : joints.find(isAtLimit);
}
