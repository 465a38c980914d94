/** Everything that keys do, and the page that explains it. */
import { CAMERAS } from '../field/camera-controller.js';
import { byId, element } from './elements.js';

/**
 * @typedef {object} Action
 * @property {string[]} keys as the browser names them
 * @property {string} shown as people read them
 * @property {string} text
 * @property {() => void} act
 * @property {boolean} [ctrl] whether Ctrl must be held
 */

/**
 * @param {object} desk
 * @param {(degreesRight: number, degreesUp: number) => void} desk.turn
 * @param {(factor: number) => void} desk.zoom
 * @param {(index: number) => void} desk.camera
 * @param {() => void} desk.next follows the next robot
 * @param {ReturnType<typeof import('./transport.js').timeActions>} time
 * @param {(command: object) => void} send
 * @returns {Action[]}
 */
export function fieldDeeds(desk, time, send) {
  return [
    { keys: [' '], shown: 'Space', text: 'pause or play', act: time.toggle },
    { keys: ['.'], shown: '.', text: 'one cycle (20 ms)', act: () => time.step(1) },
    { keys: [','], shown: ',', text: 'ten cycles', act: () => time.step(10) },
    { keys: ['+', '='], shown: '+', text: 'faster', act: time.faster },
    { keys: ['-'], shown: '−', text: 'slower', act: time.slower },
    { keys: ['r', 'R'], shown: 'R', text: 'reset', act: time.reset },
    { keys: ['z'], ctrl: true, shown: 'Ctrl+Z', text: 'undo what was done to the world', act: time.undo },
    { keys: ['Z', 'y'], ctrl: true, shown: 'Ctrl+Shift+Z', text: 'do it again', act: time.redo },
    { keys: ['k'], shown: 'K', text: 'kick-off of the left team', act: () => send({ do: 'kickOff', side: 'left' }) },
    { keys: ['l'], shown: 'L', text: 'kick-off of the right team', act: () => send({ do: 'kickOff', side: 'right' }) },
    { keys: ['b'], shown: 'B', text: 'drop ball', act: () => send({ do: 'dropBall' }) },
    ...CAMERAS.map(({ name }, i) => ({
      keys: [String(i + 1)],
      shown: String(i + 1),
      text: `camera: ${name}`,
      act: () => desk.camera(i),
    })),
    { keys: ['n', 'N'], shown: 'N', text: 'next robot', act: desk.next },
    { keys: ['ArrowLeft'], shown: '←', text: 'turn the view left', act: () => desk.turn(-6, 0) },
    { keys: ['ArrowRight'], shown: '→', text: 'turn the view right', act: () => desk.turn(6, 0) },
    { keys: ['ArrowUp'], shown: '↑', text: 'look from higher', act: () => desk.turn(0, 4) },
    { keys: ['ArrowDown'], shown: '↓', text: 'look from lower', act: () => desk.turn(0, -4) },
    { keys: ['PageUp'], shown: 'Page up', text: 'nearer', act: () => desk.zoom(0.85) },
    { keys: ['PageDown'], shown: 'Page down', text: 'farther', act: () => desk.zoom(1.18) },
  ];
}

/** With Ctrl, these go to the motion even while an angle is typed: it is the motion that is saved and undone. */
const FOR_DOCUMENT = ['s', 'z', 'y'];

/** Fields with an undo of their own. */
const WRITTEN = new Set(['text', 'search', 'number', 'textarea']);

/** What the mouse does on the pitch. */
export const FIELD_MOUSE = [
  ['Drag the ground', 'turn the view'],
  ['Right button, Shift', 'drag to move the view'],
  ['Wheel', 'nearer, farther'],
  ['Drag ball, robot', 'put it elsewhere'],
  ['Drag a robot’s ring', 'turn the robot'],
  ['Pull the ball’s ring', 'throw the ball; Shift: high'],
  ['Ctrl, drag', 'turn or throw without the ring'],
  ['Click a robot', 'follow it'],
];

/**
 * Listens to the keys of the room that one is in, and explains them.
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

/** @param {KeyboardEvent} event @returns {boolean} whether a key goes to the page and not to a field, an editor, a button or a dialog */
function isForPage(event) {
  const target = /** @type {HTMLElement} */ (event.target);
  if (target.shadowRoot) {
    return false;
  }
  const pressing = ['BUTTON', 'A', 'SUMMARY'].includes(target.tagName) && event.key === ' ';
  const forDocument = hasCtrl(event) && FOR_DOCUMENT.includes(keyOf(event).toLowerCase());
  const takesUndo = target.closest('#motion-room') === null && WRITTEN.has(/** @type {any} */ (target).type);
  const isElsewhere = !isTyping(target) || (forDocument && !takesUndo);
  return isElsewhere && !pressing && !event.altKey && !document.querySelector('dialog[open]');
}

/** @param {HTMLElement} target @returns {boolean} whether keys write something there */
export function isTyping(target) {
  const isField = ['SELECT', 'INPUT', 'TEXTAREA'].includes(target.tagName);
  return isField && /** @type {HTMLInputElement} */ (target).type !== 'range';
}

/** @param {Action} action @param {KeyboardEvent} event */
function isAskedBy(action, event) {
  return action.keys.includes(keyOf(event)) && Boolean(action.ctrl) === hasCtrl(event);
}

/** The key as it is without Caps Lock: a capital letter only together with Shift. @param {KeyboardEvent} event */
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
  const close = element('button', { type: 'button', class: 'primary' }, 'Close');
  close.addEventListener('click', () => help.close());
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
