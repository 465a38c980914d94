/**
 * Postures to begin with, and the own ones in their text file: a comment with the name before each line. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 *
 * @typedef {object} NamedPosture
 * @property {string} name
 * @property {readonly number[]} degrees
 */
import { newLine, parse } from './motion-text.js';
import { postureFrom } from './posture.js';

/** As the robot stands before most motions, like the library's motion “stand”. */
export const STANDING = {
  BOTH_SHOULDER_PITCH: -95,
  BOTH_SHOULDER_YAW: 10,
  BOTH_ARM_ROLL: -90,
  BOTH_ARM_YAW: -40,
  BOTH_HIP_PITCH: 35,
  BOTH_KNEE_PITCH: -70,
  BOTH_FOOT_PITCH: 37,
};

/** @type {Array<[string, Record<string, number>]>} */
const POSTURES = [
  ['Stand', STANDING],
  ['Straight', { BOTH_SHOULDER_PITCH: -90, BOTH_SHOULDER_YAW: 12 }],
  ['Construction pose', {}],
  ['Arms up', { ...STANDING, BOTH_SHOULDER_PITCH: 90, BOTH_SHOULDER_YAW: 15, BOTH_ARM_ROLL: 0, BOTH_ARM_YAW: -15 }],
  ['Arms wide', { ...STANDING, BOTH_SHOULDER_PITCH: 0, BOTH_SHOULDER_YAW: 88, BOTH_ARM_ROLL: 0, BOTH_ARM_YAW: 0 }],
  [
    'Crouch',
    {
      ...STANDING,
      BOTH_HIP_PITCH: 62,
      BOTH_KNEE_PITCH: -118,
      BOTH_FOOT_PITCH: 58,
      BOTH_SHOULDER_PITCH: -40,
      BOTH_ARM_ROLL: 0,
      BOTH_ARM_YAW: -20,
    },
  ],
  ['Look up', { ...STANDING, NECK_PITCH: 35 }],
];

/** @param {Body} body @returns {NamedPosture[]} */
export function usualPostures(body) {
  return POSTURES.map(([name, angles]) => ({ name, degrees: postureFrom(body, angles) }));
}

/** @param {string} text @returns {NamedPosture[]} */
export function readPostures(text) {
  const { lines } = parse(text);
  return lines.flatMap(({ keyframe }, i) => {
    const comment = /^\/\/ posture: (.+)$/.exec(lines[i - 1]?.text ?? '');
    return keyframe ? [{ name: comment?.[1] ?? `Posture ${i + 1}`, degrees: keyframe.degrees }] : [];
  });
}

/** @param {readonly NamedPosture[]} postures @returns {string} */
export function writePostures(postures) {
  return postures
    .map(({ name, degrees }) => `// posture: ${name}\n${newLine({ millis: 500, degrees }, '').text}\n`)
    .join('');
}
