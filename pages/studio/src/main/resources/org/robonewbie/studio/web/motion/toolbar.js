/** The toolbar of the motion editor. */
import { button, element, setText } from '../panels/elements.js';
import { menu } from './menu.js';
import { framesOf, isUnsaved } from '../state/motion/editor-state.js';

/**
 * @typedef {import('./editor.js').Editor} Editor
 * @typedef {import('./orders.js').Order} Order
 */

const FILE = ['save', 'save-as', 'undo', 'redo'];
const KEYFRAMES = ['duplicate', 'delete', 'copy', 'paste', 'earlier', 'later', 'mirror'];
const MOTION = ['balance', 'mirror-all', 'reverse', 'scale', 'export'];

/**
 * @param {HTMLElement} place
 * @param {Editor} editor
 * @param {Order[]} orders
 * @param {{button: HTMLButtonElement, draw: () => void}} take
 * @returns {() => void} function that updates names and enabled states
 */
export function toolbar(place, editor, orders, take) {
  const title = element('strong', { class: 'file-name', id: 'file-name' });
  const buttons = new Map(orders.map((order) => [order.id, orderButton(order)]));
  const some = (/** @type {string[]} */ ids) => ids.map((id) => /** @type {HTMLElement} */ (buttons.get(id)));
  const file = element('div', { class: 'group' }, ...some(FILE));
  place.append(
    title,
    file,
    menu('Keyframes', 'unfolding', [...some(KEYFRAMES), take.button]),
    menu('Motion', '', some(MOTION)),
  );
  return () => {
    const { state } = editor;
    setText(title, (state.name || state.draft || 'new motion') + (isUnsaved(state) ? ' •' : ''));
    title.title = isUnsaved(state) ? 'Has unsaved changes; they are also kept as a draft' : 'Saved';
    for (const { id, isForNao } of orders) {
      const made = /** @type {HTMLButtonElement} */ (buttons.get(id));
      made.hidden = isForNao === true && !state.body.isNao;
      made.disabled = !isPossible(id, editor);
    }
    drawHistory(buttons, state.history);
    take.draw();
  };
}

/**
 * Labels the undo and redo buttons with their actions.
 *
 * @param {Map<string, HTMLButtonElement>} buttons
 * @param {Editor['state']['history']} history
 */
function drawHistory(buttons, { past, present, future }) {
  /** @param {string} id @param {string} text */
  const say = (id, text) => buttons.get(id)?.setAttribute('title', text);
  say('undo', past.length > 0 ? `Undo: ${present.label} (Ctrl Z)` : 'Nothing to undo');
  say('redo', future.length > 0 ? `Redo: ${future[0].label} (Ctrl Y)` : 'Nothing to redo');
}

/** @param {string} id ID of an action @param {Editor} editor */
function isPossible(id, { state, clip }) {
  const frames = framesOf(state).length;
  /** @type {Record<string, boolean>} */
  const possible = {
    undo: state.history.past.length > 0,
    redo: state.history.future.length > 0,
    paste: clip.frames.length > 0,
    earlier: Math.min(...state.chosen) > 0,
    later: Math.max(...state.chosen) < frames - 1,
  };
  return possible[id] ?? frames > 0;
}

/** @param {Order} order */
export function orderButton({ id, name, hint, shown, act }) {
  const made = button(name, shown ? `${hint} (${shown})` : hint, act);
  made.id = id;
  return made;
}
