/**
 * Plottable values of a robot, each with a name such as “joint angle/left knee pitch”. Pure.
 *
 * @typedef {import('../kinematics.js').RobotModel} RobotModel
 * @typedef {import('../../live/state-frame.js').Frame} Frame
 * @typedef {import('./senses.js').Senses} Senses
 * @typedef {Array<readonly [string, number]>} Values
 */
import { jointName } from '../motion/names.js';
import { placeOf } from './robot-facts.js';

/** Unit of each group of values. @type {Record<string, string>} */
const UNITS = {
  'joint angle': '°',
  'joint speed': '°/s',
  'commanded speed': '°/s',
  accelerometer: 'm/s²',
  gyroscope: '°/s',
  'left foot': 'N',
  'right foot': 'N',
  'left toe': 'N',
  'right toe': 'N',
  ball: 'm',
  torso: 'm',
};

/** @type {Record<string, string>} */
const FEET = { lf: 'left foot', rf: 'right foot', lf1: 'left toe', rf1: 'right toe' };

/**
 * Returns the ground-truth values of a frame.
 *
 * @param {RobotModel} model
 * @param {Frame} frame
 * @param {number} robot index
 * @returns {Values}
 */
export function trueValues(model, frame, robot) {
  const place = placeOf(frame, robot);
  return [
    ['torso/x', place.x],
    ['torso/y', place.y],
    ['torso/height', place.height],
    ['torso/heading °', place.heading],
    ['torso/tilt °', place.tilt],
    ['ball/x', frame.ball[0]],
    ['ball/y', frame.ball[1]],
    ['ball/height', frame.ball[2]],
    ['ball/distance', place.ball],
    ...jointValues(model, 'joint angle', frame.robots[robot].degrees),
  ];
}

/**
 * Returns the values of the perceptors.
 *
 * @param {Senses} senses
 * @returns {Values}
 */
export function sensedValues({ gyro, acceleration, feet }) {
  /** @type {Values} */
  const values = [];
  const add = (/** @type {string} */ group, /** @type {string[]} */ names, /** @type {number[]} */ numbers) =>
    names.forEach((name, i) => values.push([`${group}/${name}`, numbers[i]]));
  if (acceleration) {
    add('accelerometer', ['forward', 'left', 'up'], acceleration);
  }
  if (gyro) {
    add('gyroscope', ['about forward', 'about left', 'about up'], gyro);
  }
  for (const [foot, { force }] of Object.entries(feet)) {
    add(FEET[foot] ?? foot, ['force forward', 'force left', 'force up'], force);
  }
  return values;
}

/**
 * @param {RobotModel} model
 * @param {'joint angle' | 'joint speed' | 'commanded speed'} group
 * @param {ArrayLike<number>} numbers one number per hinge, in degrees or degrees per second
 * @returns {Values}
 */
export function jointValues({ hinges }, group, numbers) {
  return hinges.map(({ joint }, i) => /** @type {const} */ ([`${group}/${jointName(joint)}`, numbers[i]]));
}

/** @param {string} name @returns {string} unit of a value, empty if it is plotted by an agent */
export function unitOf(name) {
  return name.endsWith('°') ? '°' : (UNITS[name.split('/')[0]] ?? '');
}
