/**
 * Template postures, and the user's own postures: a text file with one posture per line, each below a comment with its name. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 *
 * @typedef {object} NamedPosture
 * @property {string} name
 * @property {readonly number[]} degrees
 */
import { postureOfHinges } from './body.js';
import { contentOf, newLine, parse } from './motion-text.js';
import { postureFrom } from './posture.js';

/** Stance from which most motions start, the same as in the library's motion “stand”. */
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

/** @param {Body} body @returns {number[]} the stance from which motions start */
export function stanceOf(body) {
  return body.isNao
    ? postureFrom(body, STANDING)
    : postureOfHinges(
        body,
        body.model.hinges.map(({ stanceDegrees = 0 }) => stanceDegrees),
      );
}

/** @param {Body} body @returns {NamedPosture[]} */
export function templatePostures(body) {
  if (!body.isNao) {
    return [
      { name: 'Stand', degrees: stanceOf(body) },
      { name: 'Construction pose', degrees: body.joints.map(() => 0) },
    ];
  }
  return POSTURES.map(([name, angles]) => ({ name, degrees: postureFrom(body, angles) }));
}

/** @param {string} text @returns {NamedPosture[]} */
export function readPostures(text) {
  const { lines } = parse(text);
  return lines.flatMap(({ keyframe }, i) =>
    keyframe ? [{ name: nameOf(lines[i - 1]) ?? `Posture ${i + 1}`, degrees: keyframe.degrees }] : [],
  );
}

/**
 * Saves a posture in the file, replacing the one with the same name; all other lines are kept, whether valid or not.
 *
 * @param {string} text
 * @param {NamedPosture} posture
 * @returns {string}
 */
export function withPosture(text, { name, degrees }) {
  const document = parse(text);
  const { lines } = document;
  const line = newLine({ millis: 500, degrees }, '').text;
  const at = lines.findIndex(({ keyframe }, i) => keyframe && nameOf(lines[i - 1]) === name);
  if (at >= 0) {
    return lines.map((each, i) => (i === at ? line : each.text) + each.end).join('');
  }
  const isOpen = lines.length > 0 && lines[lines.length - 1].end === '';
  return `${contentOf(document)}${isOpen ? '\n' : ''}// posture: ${name}\n${line}\n`;
}

/** @param {import('./motion-text.js').Line | undefined} line @returns {string | undefined} */
function nameOf(line) {
  return /^\/\/ posture: (.+)$/.exec(line?.text ?? '')?.[1];
}
