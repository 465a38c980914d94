/**
 * Operations on postures. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./body.js').Posture} Posture
 */

/**
 * @param {Body} body
 * @param {number} joint index
 * @param {number} degrees
 * @returns {number} the nearest angle in the joint's range
 */
export function clamped(body, joint, degrees) {
  const { minDegrees, maxDegrees } = body.joints[joint];
  return Math.max(minDegrees, Math.min(maxDegrees, degrees));
}

/**
 * @param {Body} body
 * @param {Posture} posture
 * @returns {number[]} the mirrored posture
 */
export function mirrored(body, posture) {
  const result = new Array(posture.length).fill(0);
  body.joints.forEach(({ partner, mirrorSign }, joint) => {
    result[partner] = mirrorSign * posture[joint] + 0;
  });
  return result;
}

/**
 * Mirrors changes from one side of the body to the other.
 *
 * @param {Body} body
 * @param {Posture} before
 * @param {Posture} after
 * @returns {number[]} `after` with the partners of all changed joints mirrored
 */
export function symmetric(body, before, after) {
  const result = [...after];
  body.joints.forEach(({ partner, mirrorSign }, joint) => {
    if (partner !== joint && after[joint] !== before[joint]) {
      result[partner] = clamped(body, partner, mirrorSign * after[joint] + 0);
    }
  });
  return result;
}

/**
 * Copies one side of the body to the other.
 *
 * @param {Body} body
 * @param {Posture} posture
 * @param {'LEFT' | 'RIGHT'} side source side
 * @returns {number[]}
 */
export function copiedSide(body, posture, side) {
  const result = [...posture];
  body.joints.forEach(({ name, partner, mirrorSign }, joint) => {
    if (name.startsWith(side)) {
      result[partner] = clamped(body, partner, mirrorSign * posture[joint] + 0);
    }
  });
  return result;
}

/**
 * Creates a posture from named angles; all others are 0.
 *
 * @param {Body} body
 * @param {Record<string, number>} angles angles by joint; BOTH_KNEE_PITCH sets the left angle and mirrors it to the right
 * @returns {number[]}
 */
export function postureFrom(body, angles) {
  return body.joints.map(({ name, mirrorSign }) => {
    const both = angles[name.replace(/^LEFT_|^RIGHT_/, 'BOTH_')] ?? 0;
    return (angles[name] ?? (name.startsWith('RIGHT_') ? mirrorSign * both : both)) + 0;
  });
}

/**
 * @param {readonly number[]} before
 * @param {readonly number[]} after
 * @param {number} otherwise
 * @returns {number} the joint that has turned the most, or `otherwise` if none has
 */
export function mostTurned(before, after, otherwise) {
  const ways = after.map((angle, joint) => Math.abs(angle - before[joint]));
  const max = Math.max(...ways);
  return max > 0 ? ways.indexOf(max) : otherwise;
}
