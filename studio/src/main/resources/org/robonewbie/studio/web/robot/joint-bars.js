/** All joints of a robot: where in its range each one is, its angle, and how fast it turns. */
import { element, setText } from '../panels/elements.js';
import { JOINT_GROUPS, shortJointName } from '../state/motion/names.js';

/** @typedef {import('../state/kinematics.js').RobotModel} RobotModel */

/**
 * @param {HTMLElement} place
 * @returns {(model: RobotModel, degrees: ArrayLike<number>, speeds: ArrayLike<number>) => void}
 */
export function jointBars(place) {
  /** @type {Array<{knob: HTMLElement, angle: HTMLElement, speed: HTMLElement}>} */
  let rows = [];
  /** @type {RobotModel | undefined} */
  let shown;
  return (model, degrees, speeds) => {
    if (model !== shown) {
      shown = model;
      const made = model.hinges.map((hinge) => row(hinge));
      rows = made;
      const isOther = (/** @type {string} */ joint) => !JOINT_GROUPS.some(({ test }) => test.test(joint));
      const toes = { title: 'Toes', test: { test: isOther } };
      const groups = [...JOINT_GROUPS, ...(model.hinges.some(({ joint }) => isOther(joint)) ? [toes] : [])].map(({ title, test }) =>
        element('section', { class: 'joint-group', 'aria-label': title }, element('h2', {}, title), ...made.filter((_, i) => test.test(model.hinges[i].joint)).map(({ line }) => line)),
      );
      place.replaceChildren(...groups);
    }
    model.hinges.forEach(({ minDegrees, maxDegrees }, i) => {
      const part = (degrees[i] - minDegrees) / (maxDegrees - minDegrees);
      rows[i].knob.style.left = `${(100 * Math.max(0, Math.min(1, part))).toFixed(1)}%`;
      setText(rows[i].angle, `${degrees[i].toFixed(1)}°`);
      setText(rows[i].speed, Math.abs(speeds[i]) < 0.5 ? '' : `${speeds[i].toFixed(0)} °/s`);
    });
  };
}

/** @param {import('../state/kinematics.js').Hinge} hinge */
function row({ joint, minDegrees, maxDegrees }) {
  const knob = element('i', { class: 'knob' });
  const angle = element('span', { class: 'angle' });
  const speed = element('span', { class: 'faint' });
  const bar = element('div', { class: 'range', title: `${minDegrees}° to ${maxDegrees}°` }, knob);
  const line = element('div', { class: 'joint-row' }, element('span', {}, shortJointName(joint)), bar, angle, speed);
  return { line, knob, angle, speed };
}
