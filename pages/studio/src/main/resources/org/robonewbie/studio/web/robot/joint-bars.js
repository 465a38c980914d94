/** All joints of a robot: position within the range, angle, measured speed and commanded speed. */
import { element, setText } from '../panels/elements.js';
import { isNao } from '../state/figure.js';
import { jointGroups, jointName, shortJointName } from '../state/motion/names.js';
import { fixed } from '../state/numbers.js';

/**
 * @typedef {import('../state/robot/robot-watch.js').RobotMoment} RobotMoment
 * @typedef {import('../state/kinematics.js').Hinge} Hinge
 * @typedef {ReturnType<typeof newRow>} Row
 */

const END_DEGREES = 0.5;

/**
 * @param {HTMLElement} place
 * @returns {(moment: RobotMoment) => void}
 */
export function jointBars(place) {
  /** @type {Row[]} */
  let rows = [];
  /** @type {string} */
  let shown = '';
  return (moment) => {
    const { hinges } = moment.model;
    const names = hinges.map(({ joint }) => joint).join();
    if (names !== shown) {
      shown = names;
      rows = hinges.map(newRow);
      place.replaceChildren(columnHeads(), ...groupsOf(moment.model, rows));
    }
    drawRows(rows, moment);
  };
}

function columnHeads() {
  const texts = ['', '', 'angle', 'speed', 'command'];
  return element('div', { class: 'joint-columns' }, ...texts.map((text) => element('span', { class: 'faint' }, text)));
}

/** @param {RobotMoment['model']} model @param {readonly Row[]} rows */
function groupsOf(model, rows) {
  const names = model.hinges.map(({ joint }) => joint);
  return jointGroups(names, isNao(model) ? 'Toes' : 'Body').map(({ title, joints }) => {
    const lines = joints.map((joint) => rows[joint].line);
    return element('section', { class: 'joint-group', 'aria-label': title }, element('h2', {}, title), ...lines);
  });
}

/** @param {readonly Row[]} rows @param {RobotMoment} moment */
function drawRows(rows, { model, frame, robot, traces, seconds }) {
  const { degrees } = frame.robots[robot];
  model.hinges.forEach((hinge, i) => {
    const name = jointName(hinge.joint);
    const speed = traces.valueAt(`joint speed/${name}`, seconds);
    const command = traces.valueAt(`commanded speed/${name}`, seconds);
    drawRow(rows[i], hinge, degrees[i], speed, command);
  });
}

/**
 * @param {Row} row
 * @param {Hinge} hinge
 * @param {number} degrees
 * @param {number | undefined} speed measured, degrees per second
 * @param {number | undefined} command degrees per second
 */
function drawRow(row, { minDegrees, maxDegrees, maxSpeed }, degrees, speed, command) {
  const part = (degrees - minDegrees) / (maxDegrees - minDegrees);
  row.knob.style.left = `${(100 * Math.max(0, Math.min(1, part))).toFixed(1)}%`;
  row.knob.classList.toggle('limit', degrees < minDegrees + END_DEGREES || degrees > maxDegrees - END_DEGREES);
  setText(row.angle, `${fixed(degrees, 1)}°`);
  setText(row.speed, speed === undefined ? '' : fixed(speed, 0));
  const isTooFast = command !== undefined && Math.abs(command) > maxSpeed * 0.999;
  row.command.classList.toggle('limit', isTooFast);
  row.command.title = isTooFast ? `This motor turns at most ${maxSpeed.toFixed(0)}° per second` : '';
  setText(row.command, command === undefined ? '' : `${isTooFast ? '! ' : ''}${fixed(command, 0)}`);
}

/** @param {Hinge} hinge */
function newRow({ joint, minDegrees, maxDegrees }) {
  const knob = element('i', { class: 'knob' });
  const angle = element('span', { class: 'angle' });
  const speed = element('span', { class: 'faint' });
  const command = element('span', { class: 'command' });
  const bar = element('div', { class: 'range', title: `${minDegrees}° to ${maxDegrees}°` }, knob);
  const line = element(
    'div',
    { class: 'joint-row' },
    element('span', {}, shortJointName(joint)),
    bar,
    angle,
    speed,
    command,
  );
  return { line, knob, angle, speed, command };
}
