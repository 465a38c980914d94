/** All actions of the motion editor's buttons and keys. */
import {
  deleted,
  duplicated,
  copied,
  mirroredMotion,
  mirroredSelection,
  pasted,
  reversedMotion,
  scaledMotion,
  shifted,
} from '../state/motion/edits.js';
import { lengthOf, selected, withKeyframeHere, withRedo, withUndo } from '../state/motion/editor-state.js';
import { atMark, nextMark } from '../state/motion/marks.js';
import { withAllChosen } from '../state/motion/selection.js';
import { takeTyped } from './number-field.js';
import { makeBalanced } from './balance-order.js';
import { exportFile, importFile } from './exchange.js';
import { ask, askName } from '../panels/questions.js';

/**
 * @typedef {import('./editor.js').Editor} Editor
 * @typedef {Parameters<Editor['apply']>[0]} Edit
 *
 * @typedef {object} Order
 * @property {string} id
 * @property {string} name name on the button
 * @property {string} hint
 * @property {string[]} keys names of the keys in the browser
 * @property {string} shown label of the keys
 * @property {boolean} [ctrl] whether Ctrl must be held
 * @property {boolean} [isForNao] whether it is for motions of the NAO only
 * @property {() => void} act
 */

const BALANCE_HINT =
  'Shifts the torso until the centre of mass is above the feet, in all keyframes, or in the selected ones if more than one is selected';

/**
 * @param {Editor} editor
 * @param {(work: Promise<unknown>) => void} run runs an action and reports any failure
 * @returns {Order[]}
 */
export function ordersOf(editor, run) {
  const orders = [
    ...fileOrders(editor, run),
    ...keyframeOrders(editor),
    ...motionOrders(editor, run),
    ...timeOrders(editor),
  ];
  const isPossible = (/** @type {Order} */ { isForNao }) => !isForNao || editor.state.body.isNao;
  return orders.map((each) => ({ ...each, act: () => (takeTyped(), isPossible(each) && each.act()) }));
}

/** @param {Editor} editor @param {(work: Promise<unknown>) => void} run @returns {Order[]} */
function fileOrders(editor, run) {
  const save = () => run(needsName(editor) ? saveAs(editor) : editor.save());
  const importHint = 'Import a motion from Webots, Choregraphe, the original motion editor, or a table';
  return [
    ctrl('save', 'Save', 'Write the motion to its file', ['s'], save),
    order('save-as', 'Save as…', 'Write the motion to another file', [], '', () => run(saveAs(editor))),
    ctrl('undo', '↶ Undo', '', ['z'], () => editor.apply(withUndo)),
    ctrl('redo', '↷ Redo', '', ['y', 'Z'], () => editor.apply(withRedo)),
    order('import', 'Import…', importHint, [], '', () => run(importFile(editor))),
    order('export', 'Export…', 'Export the motion for another program', [], '', () => run(exportFile(editor))),
  ];
}

/** @param {Editor} editor @returns {Order[]} */
function keyframeOrders(editor) {
  const does = (/** @type {Edit} */ edit) => () => editor.apply(edit);
  const insert = does((state) => withKeyframeHere(state));
  const earlier = does((state) => shifted(state, -1));
  const later = does((state) => shifted(state, 1));
  const paste = does((state) => pasted(state, editor.clip));
  return [
    order('insert', '+ Keyframe', 'Insert a keyframe at the playhead', ['i', 'Insert'], 'I', insert),
    order('duplicate', 'Duplicate', 'Duplicate the selected keyframes', ['d'], 'D', does(duplicated)),
    order('delete', 'Delete', 'Delete the selected keyframes', ['Delete', 'Backspace'], 'Del', does(deleted)),
    ctrl('copy', 'Copy', 'Copy the selected keyframes', ['c'], () => copy(editor)),
    ctrl('cut', 'Cut', 'Cut the selected keyframes', ['x'], () => (copy(editor), editor.apply(deleted))),
    ctrl('paste', 'Paste', 'Insert the copied keyframes after the selected one', ['v'], paste),
    order('earlier', '◂ Move', 'Move the selected keyframes one position earlier', ['['], '[', earlier),
    order('later', 'Move ▸', 'Move the selected keyframes one position later', [']'], ']', later),
    naoOrder('mirror', 'Mirror', 'Swap left and right in the selected keyframes', ['m'], 'M', does(mirroredSelection)),
  ];
}

/** @param {Editor} editor @param {(work: Promise<unknown>) => void} run @returns {Order[]} */
function motionOrders(editor, run) {
  const does = (/** @type {Edit} */ edit) => () => editor.apply(edit);
  return [
    naoOrder('mirror-all', 'Mirror all', 'Swap left and right in the whole motion', [], '', does(mirroredMotion)),
    order('reverse', 'Reverse', 'Reverse the order of the keyframes', [], '', does(reversedMotion)),
    naoOrder('balance', 'Balance', BALANCE_HINT, [], '', () => makeBalanced(editor)),
    order('scale', 'Speed…', 'Make the whole motion slower or faster', [], '', () => run(scale(editor))),
  ];
}

/** @param {Editor} editor @returns {Order[]} */
function timeOrders(editor) {
  const step = (/** @type {number} */ by) => () => editor.apply((state) => selected(state, state.last + by));
  const layout = () => editor.apply((state) => ({ ...state, layout: state.layout === 'rows' ? 'curves' : 'rows' }));
  const all = () => editor.apply(withAllChosen);
  const nextTrouble = () => {
    const mark = nextMark(editor.marks, editor.state.time);
    if (mark) {
      editor.apply((state) => atMark(state, mark));
    }
  };
  return [
    ctrl('all', 'Select all', 'Select all keyframes', ['a'], all),
    order('layout', 'Joints or curves', 'Timeline: a row for each joint, or curves', ['r'], 'R', layout),
    order('next-mark', 'Next warning', 'Go to the next warning of the timeline', ['w'], 'W', nextTrouble),
    order('play', 'Play', 'Play the motion', [' '], 'Space', () => editor.apply(withPlayToggled)),
    order('previous', 'Previous keyframe', '', ['ArrowLeft'], '←', step(-1)),
    order('next', 'Next keyframe', '', ['ArrowRight'], '→', step(1)),
  ];
}

/**
 * @param {string} id
 * @param {string} name
 * @param {string} hint
 * @param {string[]} keys
 * @param {string} shown
 * @param {() => void} act
 * @returns {Order}
 */
function order(id, name, hint, keys, shown, act) {
  return { id, name, hint, keys, shown, act, ctrl: false };
}

/** Returns an action for motions of the NAO only; its parameters are those of `order`. @param {Parameters<typeof order>} parameters */
function naoOrder(...parameters) {
  return { ...order(...parameters), isForNao: true };
}

/**
 * @param {string} id
 * @param {string} name
 * @param {string} hint
 * @param {string[]} keys keys pressed together with Ctrl
 * @param {() => void} act
 * @returns {Order}
 */
function ctrl(id, name, hint, keys, act) {
  return { ...order(id, name, hint, keys, `Ctrl ${keys[0].toUpperCase()}`, act), ctrl: true };
}

/** @param {import('../state/motion/editor-state.js').EditorState} state */
function withPlayToggled(state) {
  const atEnd = state.time >= lengthOf(state) - 1 && !state.watching;
  return { ...state, playing: !state.playing, time: atEnd && !state.playing ? 0 : state.time };
}

/** @param {Editor} editor */
function copy(editor) {
  editor.clip = copied(editor.state);
  const { frames, rows } = editor.clip;
  const angles =
    rows.length === 0 ? '' : `, only the angles of ${rows.length === 1 ? 'a joint' : `${rows.length} joints`}`;
  const count = `${frames.length} ${frames.length === 1 ? 'keyframe' : 'keyframes'}`;
  editor.listener.note(`${count} copied${angles}. Paste them into any motion.`);
}

/** @param {Editor} editor */
async function saveAs(editor) {
  const name = await askName(editor.state.name || 'my-motion');
  return name === undefined ? undefined : editor.save(name);
}

/**
 * Returns whether a name is needed for saving, as for a motion from the library, which is saved under a new name. @param {Editor} editor
 */
function needsName({ state, list }) {
  return state.name === '' || (state.version === '' && list.library.includes(state.name));
}

/** @param {Editor} editor */
async function scale(editor) {
  const answer = await ask({
    title: 'Speed of the whole motion',
    label: 'Duration in percent',
    value: '150',
    action: 'Change',
    problem: (percent) => (/^(?!0+$)\d{1,4}$/.test(percent) ? '' : 'Enter a whole number from 1 to 9999.'),
    hint: '200 halves the speed, 50 doubles it. Times are rounded to cycles of 20 ms.',
  });
  if (answer !== undefined) {
    editor.apply((state) => scaledMotion(state, Number(answer) / 100));
  }
}
