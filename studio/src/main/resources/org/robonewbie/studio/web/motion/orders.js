/** Everything that buttons and keys of the motion editor do, in one list. */
import { deleted, duplicated, copied, mirroredMotion, mirroredSelection, pasted, reversedMotion, scaledMotion, shifted } from '../state/motion/edits.js';
import { framesOf, lengthOf, selected, withKeyframeHere, withRedo, withUndo } from '../state/motion/editor-state.js';
import { keyframesOf } from '../state/motion/motion-document.js';
import { parse } from '../state/motion/motion-text.js';
import { readWebots, writeWebots } from '../state/motion/webots.js';
import { ask, askFile, askName, offer } from './questions.js';

/**
 * @typedef {import('./editor.js').Editor} Editor
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
  const apply = (/** @type {Parameters<Editor['apply']>[0]} */ edit) => () => editor.apply(edit);
  const copy = () => {
    editor.clip = copied(editor.state);
    editor.listener.note(`${editor.clip.length} ${editor.clip.length === 1 ? 'keyframe' : 'keyframes'} copied. Paste them into any motion.`);
  };
  const saveAs = async () => {
    const name = await askName(editor.state.name || 'my-motion');
    return name === undefined ? undefined : editor.save(name);
  };
  const step = (/** @type {number} */ by) => apply((state) => selected(state, state.last + by));
  const play = apply((state) => {
    const atEnd = state.time >= lengthOf(state) - 1 && !state.trial;
    return { ...state, playing: !state.playing, time: atEnd && !state.playing ? 0 : state.time };
  });
  return [
    order('save', 'Save', 'Write the motion to its file', ['s'], 'Ctrl S', () => run(needsName(editor) ? saveAs() : editor.save()), true),
    order('save-as', 'Save as…', 'Write the motion to another file', [], '', () => run(saveAs())),
    order('undo', '↶ Undo', '', ['z'], 'Ctrl Z', apply(withUndo), true),
    order('redo', '↷ Redo', '', ['y', 'Z'], 'Ctrl Y', apply(withRedo), true),
    order('insert', '+ Keyframe', 'A new keyframe at the playhead', ['i', 'Insert'], 'I', apply((state) => withKeyframeHere(state))),
    order('duplicate', 'Duplicate', 'The chosen keyframes once more', ['d'], 'D', apply(duplicated)),
    order('delete', 'Delete', 'Remove the chosen keyframes', ['Delete', 'Backspace'], 'Del', apply(deleted)),
    order('copy', 'Copy', 'Keep the chosen keyframes for any motion', ['c'], 'Ctrl C', copy, true),
    order('paste', 'Paste', 'Put the copied keyframes in after the chosen one', ['v'], 'Ctrl V', apply((state) => pasted(state, editor.clip)), true),
    order('earlier', '◂ Move', 'The chosen keyframes one place earlier', ['['], '[', apply((state) => shifted(state, -1))),
    order('later', 'Move ▸', 'The chosen keyframes one place later', [']'], ']', apply((state) => shifted(state, 1))),
    order('mirror', 'Mirror', 'Exchange left and right in the chosen keyframes', ['m'], 'M', apply(mirroredSelection)),
    order('mirror-all', 'Mirror all', 'Exchange left and right in the whole motion', [], '', apply(mirroredMotion)),
    order('reverse', 'Reverse', 'Play the motion backwards', [], '', apply(reversedMotion)),
    order('scale', 'Tempo…', 'Make the whole motion slower or faster', [], '', () => run(scale(editor))),
    order('play', 'Play', 'Show the motion', [' '], 'Space', play),
    order('previous', 'Previous keyframe', '', ['ArrowLeft'], '←', step(-1)),
    order('next', 'Next keyframe', '', ['ArrowRight'], '→', step(1)),
    order('import', 'Import…', 'Take over a motion of Webots (.motion) or another text file', [], '', () => run(importFile(editor))),
    order('export', 'Export .motion', 'Give the motion to Webots', [], '', () => offer(`${editor.state.name || 'motion'}.motion`, writeWebots(framesOf(editor.state)))),
  ];
}

/**
 * @param {string} id
 * @param {string} name
 * @param {string} hint
 * @param {string[]} keys
 * @param {string} shown
 * @param {() => void} act
 * @param {boolean} [ctrl]
 * @returns {Order}
 */
function order(id, name, hint, keys, shown, act, ctrl = false) {
  return { id, name, hint, keys, shown, act, ctrl };
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
