/** Keyboard handling, and the help dialog that lists the keys. */
import { CAMERAS } from '../field/camera-controller.js';
import { button, byId, element } from './elements.js';

/**
 * @typedef {object} Action
 * @property {string[]} keys names of the keys in the browser
 * @property {string} shown label of the keys
 * @property {string} text
 * @property {() => void} act
 * @property {boolean} [ctrl] whether Ctrl must be held
 */

/**
 * @param {object} camera
 * @param {(degreesRight: number, degreesUp: number) => void} camera.turn
 * @param {(factor: number) => void} camera.zoom
 * @param {(index: number) => void} camera.select
 * @param {() => void} camera.next follows the next robot
 * @param {ReturnType<typeof import('./transport.js').timeActions>} time
 * @param {(command: object) => void} send
 * @returns {Action[]}
 */
export function fieldActions(camera, time, send) {
  return [
    { keys: [' '], shown: 'Space', text: 'pause or play', act: time.toggle },
    { keys: ['.'], shown: '.', text: 'one cycle (20 ms)', act: () => time.step(1) },
    { keys: [','], shown: ',', text: 'ten cycles', act: () => time.step(10) },
    { keys: ['+', '='], shown: '+', text: 'faster', act: time.faster },
    { keys: ['-'], shown: '−', text: 'slower', act: time.slower },
    { keys: ['r', 'R'], shown: 'R', text: 'reset', act: time.reset },
    { keys: ['z'], ctrl: true, shown: 'Ctrl+Z', text: 'undo the last change to the world', act: time.undo },
    { keys: ['Z', 'y'], ctrl: true, shown: 'Ctrl+Shift+Z', text: 'redo', act: time.redo },
    { keys: ['k'], shown: 'K', text: 'kick-off for the left team', act: () => send({ do: 'kickOff', side: 'left' }) },
    { keys: ['l'], shown: 'L', text: 'kick-off for the right team', act: () => send({ do: 'kickOff', side: 'right' }) },
    { keys: ['b'], shown: 'B', text: 'drop ball', act: () => send({ do: 'dropBall' }) },
    ...CAMERAS.map(({ name }, i) => ({
      keys: [String(i + 1)],
      shown: String(i + 1),
      text: `camera: ${name}`,
      act: () => camera.select(i),
    })),
    { keys: ['n', 'N'], shown: 'N', text: 'next robot', act: camera.next },
    { keys: ['ArrowLeft'], shown: '←', text: 'turn the view left', act: () => camera.turn(-6, 0) },
    { keys: ['ArrowRight'], shown: '→', text: 'turn the view right', act: () => camera.turn(6, 0) },
    { keys: ['ArrowUp'], shown: '↑', text: 'move the camera up', act: () => camera.turn(0, 4) },
    { keys: ['ArrowDown'], shown: '↓', text: 'move the camera down', act: () => camera.turn(0, -4) },
    { keys: ['PageUp'], shown: 'Page up', text: 'nearer', act: () => camera.zoom(0.85) },
    { keys: ['PageDown'], shown: 'Page down', text: 'farther', act: () => camera.zoom(1.18) },
  ];
}

/** Ctrl shortcuts that act on the document even while a field has the focus. */
const FOR_DOCUMENT = ['s', 'z', 'y'];

/** Input types with their own undo. */
const WRITTEN = new Set(['text', 'search', 'number', 'textarea']);

/** Mouse actions on the pitch. */
export const FIELD_MOUSE = [
  ['Drag the ground', 'turn the view'],
  ['Right button, Shift', 'drag to move the view'],
  ['Wheel', 'nearer, farther'],
  ['Drag ball, robot', 'move it'],
  ['Drag a robot’s ring', 'turn the robot'],
  ['Pull the ball’s ring', 'throw the ball; Shift: high'],
  ['Ctrl, drag', 'turn or throw without the ring'],
  ['Click a robot', 'follow it'],
];

/**
 * Handles the keys of the current room, and lists them in the help dialog.
 *
 * @param {() => {actions: Action[], mouse: string[][]}} current
 */
export function listenToKeys(current) {
  const help = /** @type {HTMLDialogElement} */ (byId('help'));
  const explain = () => {
    fillHelp(help, current());
    help.showModal();
  };
  byId('help-button').addEventListener('click', explain);
  document.addEventListener('keydown', (event) => {
    if (isForPage(event)) {
      if (event.key === '?') {
        explain();
      }
      const action = current().actions.find((each) => isAskedBy(each, event));
      if (action) {
        event.preventDefault();
        action.act();
      }
    }
  });
}

/** @param {KeyboardEvent} event @returns {boolean} whether the key is for the page and not for a field, an editor, a button or a dialog */
function isForPage(event) {
  const target = /** @type {HTMLElement} */ (event.target);
  if (target.shadowRoot) {
    return false;
  }
  const isPressed = ['BUTTON', 'A', 'SUMMARY'].includes(target.tagName) || target.matches('[type=checkbox]');
  const pressing = isPressed && event.key === ' ';
  const forDocument = hasCtrl(event) && FOR_DOCUMENT.includes(keyOf(event).toLowerCase());
  const takesUndo = target.closest('#motion-room') === null && WRITTEN.has(/** @type {any} */ (target).type);
  const isElsewhere = !isTyping(target) || (forDocument && !takesUndo);
  return isElsewhere && !pressing && !event.altKey && !document.querySelector('dialog[open]');
}

/** @param {HTMLElement} target @returns {boolean} whether it accepts text input */
export function isTyping(target) {
  const isField = ['SELECT', 'INPUT', 'TEXTAREA'].includes(target.tagName);
  return isField && !['range', 'checkbox'].includes(/** @type {HTMLInputElement} */ (target).type);
}

/** @param {Action} action @param {KeyboardEvent} event */
function isAskedBy(action, event) {
  return action.keys.includes(keyOf(event)) && Boolean(action.ctrl) === hasCtrl(event);
}

/** Returns the key regardless of Caps Lock: a capital letter only if Shift is pressed. @param {KeyboardEvent} event */
function keyOf({ key, shiftKey }) {
  const isLetter = key.length === 1;
  return isLetter && shiftKey ? key.toUpperCase() : isLetter ? key.toLowerCase() : key;
}

/** @param {KeyboardEvent} event */
function hasCtrl(event) {
  return event.ctrlKey || event.metaKey;
}

/**
 * @param {HTMLDialogElement} help
 * @param {{actions: Action[], mouse: string[][]}} room
 */
function fillHelp(help, { actions, mouse }) {
  /** @param {string} key @param {string} text */
  const row = (key, text) => element('div', {}, element('dt', {}, element('kbd', {}, key)), element('dd', {}, text));
  const close = button('Close', '', () => help.close(), { class: 'primary' });
  help.replaceChildren(
    element('h2', {}, 'Keys and mouse'),
    element(
      'dl',
      {},
      ...actions.map((action) => row(action.shown, action.text)),
      ...mouse.map(([key, text]) => row(key, text)),
      row('?', 'this list'),
    ),
    close,
  );
}
