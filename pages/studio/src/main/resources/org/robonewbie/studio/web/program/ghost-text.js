/** Shows a proposed change to the program as grey text, which Tab or a click inserts. */
import { Decoration, EditorView, keymap, StateEffect, StateField, WidgetType } from 'codemirror';
import { element } from '../panels/elements.js';
import { ghostOf } from '../state/program/first-minute.js';

/** @typedef {import('../state/program/first-minute.js').Level} Level */

/** @type {import('@codemirror/state').StateEffectType<Level | undefined>} */
const setLevel = StateEffect.define();

class GhostWidget extends WidgetType {
  /** @param {string} text */
  constructor(text) {
    super();
    this.text = text;
  }

  /** @param {GhostWidget} other */
  eq(other) {
    return other.text === this.text;
  }

  /** @param {EditorView} view */
  toDOM(view) {
    const made = element('span', { class: 'cm-ghost', 'aria-hidden': 'true' }, this.text);
    made.addEventListener('mousedown', (event) => {
      event.preventDefault();
      insertGhost(view);
    });
    return made;
  }
}

const LEVEL = StateField.define({
  create: () => /** @type {Level | undefined} */ (undefined),
  update: (before, { effects }) => {
    const change = effects.find((each) => each.is(setLevel));
    return change ? change.value : before;
  },
  provide: (field) => EditorView.decorations.compute([field, 'doc'], decorations),
});

/** @param {import('@codemirror/state').EditorState} state @returns {import('../state/program/first-minute.js').Ghost | undefined} */
function ghostIn(state) {
  const level = state.field(LEVEL, false);
  return level && ghostOf(state.doc.toString(), level);
}

/** @param {import('@codemirror/state').EditorState} state @returns {import('@codemirror/view').DecorationSet} */
function decorations(state) {
  const ghost = ghostIn(state);
  if (!ghost) {
    return Decoration.none;
  }
  const { from, to, insert } = ghost;
  const widget = Decoration.widget({ widget: new GhostWidget(insert), side: 1 }).range(to);
  return Decoration.set(to > from ? [Decoration.mark({ class: 'cm-ghost-old' }).range(from, to), widget] : [widget]);
}

/** @param {EditorView} view @returns {boolean} whether there is a proposed change */
function insertGhost(view) {
  const ghost = ghostIn(view.state);
  if (ghost) {
    const { from, to, insert } = ghost;
    view.dispatch({ changes: { from, to, insert }, selection: { anchor: from + insert.length }, userEvent: 'input' });
    view.focus();
  }
  return ghost !== undefined;
}

const look = EditorView.baseTheme({
  '.cm-ghost': { color: 'var(--faint)', fontStyle: 'italic', cursor: 'pointer' },
  '.cm-ghost::after': {
    content: '""',
    display: 'inline-block',
    width: '28px',
    height: '18px',
    margin: '0 10px',
    verticalAlign: 'middle',
    backgroundColor: 'var(--right)',
    clipPath: 'polygon(0 50%, 45% 0, 45% 30%, 100% 30%, 100% 70%, 45% 70%, 45% 100%)',
  },
  '@media (prefers-reduced-motion: no-preference)': {
    '.cm-ghost::after': { animation: 'cm-ghost 0.9s ease-in-out infinite alternate' },
  },
  '@keyframes cm-ghost': { to: { transform: 'translateX(7px)' } },
  '.cm-ghost-old': { textDecoration: 'line-through', backgroundColor: 'var(--code-failed)' },
});

export const GHOST_TEXT = [LEVEL, keymap.of([{ key: 'Tab', run: insertGhost }]), look];

/**
 * Proposes the changes that a program still needs to pass a level, and moves the cursor to the first one.
 *
 * @param {EditorView} view
 * @param {Level | undefined} level undefined for none
 */
export function showGhost(view, level) {
  view.dispatch({ effects: setLevel.of(level) });
  const ghost = ghostIn(view.state);
  if (ghost) {
    view.dispatch({ selection: { anchor: ghost.from, head: ghost.to }, scrollIntoView: true });
  }
}
