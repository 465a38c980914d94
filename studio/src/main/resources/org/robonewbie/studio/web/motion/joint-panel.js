/** All joints of the robot with slider and number; typed angles keep their decimals. */
import { button, element } from '../panels/elements.js';
import { postureNow } from '../state/motion/editor-state.js';
import { JOINT_GROUPS, jointName, shortJointName } from '../state/motion/names.js';
import { numberText } from '../state/motion/motion-text.js';

/**
 * @typedef {import('../state/motion/editor-state.js').EditorState} EditorState
 *
 * @typedef {object} Row
 * @property {HTMLElement} line
 * @property {HTMLInputElement} slider
 * @property {HTMLInputElement} number
 */

/**
 * @param {HTMLElement} place
 * @param {import('../state/motion/body.js').Body} body
 * @param {object} editor
 * @param {(joint: number, degrees: number, gesture: string) => void} editor.turn
 * @param {(joint: number) => void} editor.choose
 * @param {(side: 'LEFT' | 'RIGHT') => void} editor.copySide
 * @param {(on: boolean) => void} editor.setSymmetric
 * @returns {(state: EditorState) => void} draws the angles
 */
export function jointPanel(place, body, editor) {
  let gestures = 0;
  let gesture = '';
  /** @type {Row[]} */
  const rows = body.joints.map((joint, i) => {
    const { name, minDegrees, maxDegrees } = joint;
    const range = `${minDegrees}° to ${maxDegrees}°`;
    const slider = element('input', {
      type: 'range',
      min: String(minDegrees),
      max: String(maxDegrees),
      step: '0.1',
      'aria-label': jointName(name),
      title: range,
    });
    const number = element('input', { type: 'text', inputmode: 'decimal', 'aria-label': `${jointName(name)} in degrees`, title: range });
    number.dataset.joint = name;
    slider.dataset.slider = name;
    slider.addEventListener('pointerdown', () => {
      gesture = `slider ${++gestures}`;
    });
    slider.addEventListener('input', () => editor.turn(i, Number(slider.value), gesture));
    const take = () => {
      const degrees = Number(number.value.replace(',', '.'));
      if (number.value.trim() !== '' && Number.isFinite(degrees)) {
        editor.turn(i, degrees, '');
      }
      number.dataset.typed = '';
    };
    number.addEventListener('input', () => {
      number.dataset.typed = 'yes';
    });
    number.addEventListener('change', take);
    number.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') {
        take();
      } else if (event.key === 'ArrowUp' || event.key === 'ArrowDown') {
        event.preventDefault();
        const step = (event.shiftKey ? 10 : 1) * (event.key === 'ArrowUp' ? 1 : -1);
        editor.turn(i, Math.round((Number(number.value) + step) * 1e4) / 1e4, `keys ${i}`);
      }
    });
    for (const field of [slider, number]) {
      field.addEventListener('focus', () => editor.choose(i));
    }
    const line = element('div', { class: 'joint' }, element('span', { class: 'joint-name' }, shortJointName(name)), slider, number);
    return { line, slider, number };
  });
  const symmetric = element('input', { type: 'checkbox', id: 'symmetric' });
  symmetric.addEventListener('change', () => editor.setSymmetric(symmetric.checked));
  place.append(
    element(
      'div',
      { class: 'both-sides' },
      element('label', { class: 'check', title: 'What one arm or leg does, the other does too' }, symmetric, 'Both sides alike'),
      button('L→R', 'Copy the left arm and leg to the right', () => editor.copySide('LEFT')),
      button('R→L', 'Copy the right arm and leg to the left', () => editor.copySide('RIGHT')),
    ),
    ...JOINT_GROUPS.map(({ title, test }) =>
      element('section', { class: 'joint-group', 'aria-label': title }, element('h2', {}, title), ...rows.filter((_, i) => test.test(body.joints[i].name)).map(({ line }) => line)),
    ),
  );
  return (state) => {
    const posture = postureNow(state);
    symmetric.checked = state.symmetric;
    rows.forEach(({ line, slider, number }, i) => {
      const { minDegrees, maxDegrees } = body.joints[i];
      slider.value = String(posture[i]);
      if (number.dataset.typed !== 'yes') {
        number.value = shownAngle(posture[i]);
      }
      line.classList.toggle('beyond', posture[i] < minDegrees || posture[i] > maxDegrees);
      line.classList.toggle('chosen', i === state.joint);
    });
  };
}

/** @param {number} degrees @returns {string} as it is in the file, but between keyframes not longer than needed */
function shownAngle(degrees) {
  return numberText(Math.round(degrees * 1e4) / 1e4 + 0);
}
