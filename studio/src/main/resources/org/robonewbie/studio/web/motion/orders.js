/** Everything that buttons and keys of the motion editor do, in one list. */
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
import { framesOf, lengthOf, selected, withKeyframeHere, withRedo, withUndo } from '../state/motion/editor-state.js';
import { keyframesOf } from '../state/motion/motion-document.js';
import { parse } from '../state/motion/motion-text.js';
import { readWebots, writeWebots } from '../state/motion/webots.js';
import { offer } from '../panels/elements.js';
import { takeTyped } from './number-field.js';
import { ask, askFile, askName } from './questions.js';

/**
 * @typedef {import('./editor.js').Editor} Editor
 * @typedef {Parameters<Editor['apply']>[0]} Edit
 *
 * @typedef {object} Order
 * @property {string} id
 * @property {string} name on the button
 * @property {string} hint
 * @property {string[]} keys as the browser names them
 * @property {string} shown the keys as people read them
 * @property {boolean} [ctrl] whether Ctrl must be held
 * @property {() => void} act
 */

/**
 * @param {Editor} editor
 * @param {(work: Promise<unknown>) => void} run reports what goes wrong
 * @returns {Order[]}
 */
export function ordersOf(editor, run) {
  const orders = [
    ...fileOrders(editor, run),
    ...keyframeOrders(editor),
    ...motionOrders(editor, run),
    ...timeOrders(editor),
  ];
  return orders.map((each) => ({ ...each, act: () => (takeTyped(), each.act()) }));
}

/** @param {Editor} editor @param {(work: Promise<unknown>) => void} run @returns {Order[]} */
function fileOrders(editor, run) {
  const save = () => run(needsName(editor) ? saveAs(editor) : editor.save());
  const send = () => offer(`${editor.state.name || 'motion'}.motion`, writeWebots(framesOf(editor.state)));
  const importHint = 'Take over a motion of Webots (.motion) or another text file';
  return [
    ctrl('save', 'Save', 'Write the motion to its file', ['s'], save),
    order('save-as', 'Save as…', 'Write the motion to another file', [], '', () => run(saveAs(editor))),
    ctrl('undo', '↶ Undo', '', ['z'], () => editor.apply(withUndo)),
    ctrl('redo', '↷ Redo', '', ['y', 'Z'], () => editor.apply(withRedo)),
    order('import', 'Import…', importHint, [], '', () => run(importFile(editor))),
    order('export', 'Export .motion', 'Give the motion to Webots', [], '', send),
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
    order('insert', '+ Keyframe', 'A new keyframe at the playhead', ['i', 'Insert'], 'I', insert),
    order('duplicate', 'Duplicate', 'The chosen keyframes once more', ['d'], 'D', does(duplicated)),
    order('delete', 'Delete', 'Remove the chosen keyframes', ['Delete', 'Backspace'], 'Del', does(deleted)),
    ctrl('copy', 'Copy', 'Keep the chosen keyframes for any motion', ['c'], () => copy(editor)),
    ctrl('paste', 'Paste', 'Put the copied keyframes in after the chosen one', ['v'], paste),
    order('earlier', '◂ Move', 'The chosen keyframes one place earlier', ['['], '[', earlier),
    order('later', 'Move ▸', 'The chosen keyframes one place later', [']'], ']', later),
    order('mirror', 'Mirror', 'Exchange left and right in the chosen keyframes', ['m'], 'M', does(mirroredSelection)),
  ];
}

/** @param {Editor} editor @param {(work: Promise<unknown>) => void} run @returns {Order[]} */
function motionOrders(editor, run) {
  const does = (/** @type {Edit} */ edit) => () => editor.apply(edit);
  return [
    order('mirror-all', 'Mirror all', 'Exchange left and right in the whole motion', [], '', does(mirroredMotion)),
    order('reverse', 'Reverse', 'Play the motion backwards', [], '', does(reversedMotion)),
    order('scale', 'Tempo…', 'Make the whole motion slower or faster', [], '', () => run(scale(editor))),
  ];
}

/** @param {Editor} editor @returns {Order[]} */
function timeOrders(editor) {
  const step = (/** @type {number} */ by) => () => editor.apply((state) => selected(state, state.last + by));
  return [
    order('play', 'Play', 'Show the motion', [' '], 'Space', () => editor.apply(withPlayToggled)),
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

/**
 * @param {string} id
 * @param {string} name
 * @param {string} hint
 * @param {string[]} keys pressed together with Ctrl
 * @param {() => void} act
 * @returns {Order}
 */
function ctrl(id, name, hint, keys, act) {
  return { ...order(id, name, hint, keys, `Ctrl ${keys[0].toUpperCase()}`, act), ctrl: true };
}

/** @param {import('../state/motion/editor-state.js').EditorState} state */
function withPlayToggled(state) {
  const atEnd = state.time >= lengthOf(state) - 1 && !state.trial;
  return { ...state, playing: !state.playing, time: atEnd && !state.playing ? 0 : state.time };
}

/** @param {Editor} editor */
function copy(editor) {
  editor.clip = copied(editor.state);
  const count = editor.clip.length;
  editor.listener.note(`${count} ${count === 1 ? 'keyframe' : 'keyframes'} copied. Paste them into any motion.`);
}

/** @param {Editor} editor */
async function saveAs(editor) {
  const name = await askName(editor.state.name || 'my-motion');
  return name === undefined ? undefined : editor.save(name);
}

/** A motion of the library is kept under a name that the person chooses. @param {Editor} editor */
function needsName({ state, list }) {
  return state.name === '' || (state.version === '' && list.library.includes(state.name));
}

/** @param {Editor} editor */
async function scale(editor) {
  const answer = await ask({
    title: 'Tempo of the whole motion',
    label: 'Duration in percent',
    value: '150',
    action: 'Change',
    pattern: /^(?!0+$)\d{1,4}$/,
    hint: '200 makes it twice as slow, 50 twice as fast. Times stay whole cycles of 20 ms.',
  });
  if (answer !== undefined) {
    editor.apply((state) => scaledMotion(state, Number(answer) / 100));
  }
}

/** @param {Editor} editor */
async function importFile(editor) {
  const file = await askFile('.motion,.txt');
  if (file) {
    const text = await file.text();
    const frames = text.startsWith('#WEBOTS') ? readWebots(text) : keyframesOf(parse(text));
    await editor.take(frames, file.name);
  }
}
