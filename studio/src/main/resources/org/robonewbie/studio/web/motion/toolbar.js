/** The buttons of the motion editor. */
import { button, element, setText } from '../panels/elements.js';
import { framesOf, isUnsaved } from '../state/motion/editor-state.js';

/**
 * @typedef {import('./editor.js').Editor} Editor
 * @typedef {import('./orders.js').Order} Order
 */

const TOP = [
  ['save', 'save-as', 'undo', 'redo'],
  ['duplicate', 'delete', 'copy', 'paste', 'earlier', 'later'],
  ['mirror', 'mirror-all', 'reverse', 'scale'],
  ['export'],
];

/**
 * @param {HTMLElement} place
 * @param {Editor} editor
 * @param {Order[]} orders
 * @returns {() => void} draws names and what is possible
 */
export function toolbar(place, editor, orders) {
  const title = element('strong', { class: 'file-name', id: 'file-name' });
  const buttons = new Map(orders.map((order) => [order.id, orderButton(order)]));
  const groups = TOP.map((ids) =>
    element('div', { class: 'group' }, ...ids.map((id) => /** @type {HTMLElement} */ (buttons.get(id)))),
  );
  place.append(title, ...groups);
  return () => {
    const { state } = editor;
    setText(title, (state.name || state.draft || 'new motion') + (isUnsaved(state) ? ' •' : ''));
    title.title = isUnsaved(state) ? 'Has unsaved changes; they are also kept as a draft' : 'Saved';
    for (const [id, made] of buttons) {
      made.disabled = !isPossible(id, editor);
    }
    drawHistory(buttons, state.history);
  };
}

/** Names what undo and redo would do. @param {Map<string, HTMLButtonElement>} buttons @param {Editor['state']['history']} history */
function drawHistory(buttons, { past, present, future }) {
  /** @param {string} id @param {string} text */
  const say = (id, text) => buttons.get(id)?.setAttribute('title', text);
  say('undo', past.length > 0 ? `Undo: ${present.label} (Ctrl Z)` : 'Nothing to undo');
  say('redo', future.length > 0 ? `Redo: ${future[0].label} (Ctrl Y)` : 'Nothing to redo');
}

/** @param {string} id of an order @param {Editor} editor */
function isPossible(id, { state, clip }) {
  const frames = framesOf(state).length;
  /** @type {Record<string, boolean>} */
  const possible = {
    undo: state.history.past.length > 0,
    redo: state.history.future.length > 0,
    paste: clip.length > 0,
    earlier: Math.min(state.first, state.last) > 0,
    later: Math.max(state.first, state.last) < frames - 1,
  };
  return possible[id] ?? frames > 0;
}

/** @param {Order} order */
export function orderButton({ id, name, hint, shown, act }) {
  const made = button(name, shown ? `${hint} (${shown})` : hint, act);
  made.id = id;
  return made;
}
