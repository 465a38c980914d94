/** Panel with a slider and a number field for each joint; typed angles keep their decimals. */
import { button, check, element } from '../panels/elements.js';
import { postureNow } from '../state/motion/editor-state.js';
import { jointGroups, jointName, shortJointName } from '../state/motion/names.js';
import { numberText } from '../state/motion/motion-text.js';
import { fourDecimals, numberOf } from '../state/numbers.js';
import { numberField, showNumber, takeTyped } from './number-field.js';

/**
 * @typedef {import('../state/motion/editor-state.js').EditorState} EditorState
 * @typedef {import('../state/motion/body.js').Body} Body
 *
 * @typedef {object} JointEditor
 * @property {(joint: number, degrees: number, gesture: string) => void} turn
 * @property {(joint: number) => void} choose
 * @property {(side: 'LEFT' | 'RIGHT') => void} copySide
 * @property {(on: boolean) => void} setSymmetric
 * @property {(text: string) => void} note
 *
 * @typedef {object} Row
 * @property {HTMLElement} line
 * @property {HTMLInputElement} slider
 * @property {HTMLInputElement} number
 */

/** Limit for typed angles in degrees; no joint turns further. */
const MAX_DEGREES = 360;

/**
 * @param {HTMLElement} place
 * @param {JointEditor} editor
 * @returns {(state: EditorState) => void} function that updates the angles
 */
export function jointPanel(place, editor) {
  /** @type {Body | undefined} */
  let shown;
  /** @type {Row[]} */
  let rows = [];
  const symmetric = check('symmetric', 'Symmetric', 'Mirrors each change to an arm or leg on the other side', (on) =>
    editor.setSymmetric(on),
  );
  const bothSides = element(
    'div',
    { class: 'both-sides' },
    symmetric.label,
    button('L→R', 'Copy the left arm and leg to the right', () => editor.copySide('LEFT')),
    button('R→L', 'Copy the right arm and leg to the left', () => editor.copySide('RIGHT')),
  );
  return (state) => {
    const { body } = state;
    if (body !== shown) {
      shown = body;
      rows = body.joints.map((joint, i) => jointRow(joint, i, editor));
      const names = body.joints.map(({ name }) => name);
      const groups = jointGroups(names, 'Body').map(({ title, joints }) =>
        jointGroup(
          title,
          joints.map((joint) => rows[joint]),
        ),
      );
      place.replaceChildren(...(body.isNao ? [bothSides] : []), ...groups);
    }
    const posture = postureNow(state);
    symmetric.box.checked = state.symmetric;
    rows.forEach((row, i) => drawRow(row, body.joints[i], posture[i], i === state.joint));
  };
}

/** @param {string} title @param {Row[]} rows */
function jointGroup(title, rows) {
  const lines = rows.map(({ line }) => line);
  return element('section', { class: 'joint-group', 'aria-label': title }, element('h2', {}, title), ...lines);
}

/** @param {Body['joints'][number]} joint @param {number} index @param {JointEditor} editor @returns {Row} */
function jointRow({ name, minDegrees, maxDegrees }, index, editor) {
  const [min, max] = [String(minDegrees), String(maxDegrees)];
  const title = `${min}° to ${max}°`;
  const slider = element('input', { type: 'range', min, max, step: '0.1', 'aria-label': jointName(name), title });
  const label = `${jointName(name)} in degrees`;
  const number = numberField(
    { inputmode: 'decimal', 'aria-label': label, title },
    MAX_DEGREES,
    (degrees) => editor.turn(index, degrees, ''),
    (text) => editor.note(`“${text}” is not an angle in degrees: ${jointName(name).toLowerCase()} stays as it is.`),
  );
  number.dataset.joint = name;
  slider.dataset.slider = name;
  for (const field of [slider, number]) {
    field.addEventListener('focus', () => editor.choose(index));
  }
  listenToSlider(slider, (degrees, gesture) => editor.turn(index, degrees, gesture));
  listenToArrows(number, (degrees) => editor.turn(index, degrees, `keys ${index}`));
  const text = element('span', { class: 'joint-name' }, shortJointName(name));
  return { line: element('div', { class: 'joint' }, text, slider, number), slider, number };
}

/** Makes one drag of the slider one undo step. @param {HTMLInputElement} slider @param {(degrees: number, gesture: string) => void} turn */
function listenToSlider(slider, turn) {
  let drags = 0;
  slider.addEventListener('pointerdown', () => {
    drags += 1;
  });
  slider.addEventListener('input', () => turn(Number(slider.value), `slider ${slider.dataset.slider} ${drags}`));
}

/**
 * Makes the Up and Down arrow keys turn the joint by one degree, or by ten with Shift.
 *
 * @param {HTMLInputElement} number
 * @param {(degrees: number) => void} turn
 */
function listenToArrows(number, turn) {
  number.addEventListener('keydown', (event) => {
    if (event.key === 'ArrowUp' || event.key === 'ArrowDown') {
      event.preventDefault();
      takeTyped();
      const step = (event.shiftKey ? 10 : 1) * (event.key === 'ArrowUp' ? 1 : -1);
      const degrees = numberOf(number.value);
      if (degrees !== undefined && Math.abs(degrees + step) <= MAX_DEGREES) {
        turn(fourDecimals(degrees + step));
      }
    }
  });
}

/** @param {Row} row @param {Body['joints'][number]} joint @param {number} degrees @param {boolean} isChosen */
function drawRow({ line, slider, number }, { minDegrees, maxDegrees }, degrees, isChosen) {
  slider.value = String(degrees);
  showNumber(number, numberText(fourDecimals(degrees)));
  line.classList.toggle('beyond', degrees < minDegrees || degrees > maxDegrees);
  line.classList.toggle('chosen', isChosen);
}
