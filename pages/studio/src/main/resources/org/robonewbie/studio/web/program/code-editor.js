/** Code editor with a separate undo history per program. Independent of files and compiler. */
import {
  autocompletion,
  bracketMatching,
  closeBrackets,
  closeBracketsKeymap,
  Compartment,
  completionKeymap,
  defaultKeymap,
  drawSelection,
  EditorState,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  highlightSelectionMatches,
  history,
  historyKeymap,
  indentLess,
  indentMore,
  indentOnInput,
  indentSelection,
  indentUnit,
  java,
  keymap,
  lineNumbers,
  lintGutter,
  search,
  searchKeymap,
  setDiagnostics,
  Transaction,
} from 'codemirror';
import { element } from '../panels/elements.js';
import { rangeOf } from '../state/program/remarks.js';
import { LOOK } from './editor-look.js';
import { GHOST_TEXT } from './ghost-text.js';
import { SAID_LINES, showMessages, showValues } from './said-lines.js';

/**
 * @typedef {import('../state/program/remarks.js').Remark} Remark
 * @typedef {import('../state/program/remarks.js').Mistake} Mistake
 *
 * @typedef {object} Listener
 * @property {() => void} changed called when the user has changed the text
 * @property {import('@codemirror/autocomplete').CompletionSource} complete
 * @property {() => void} save
 * @property {() => void} run
 */

const MAX_SAID = 6;

export class CodeEditor {
  /** @type {Map<string, EditorState>} */
  #left = new Map();
  #name = '';
  #readOnly = new Compartment();
  /** @type {readonly Remark[]} */
  #remarks = [];
  /** @type {readonly Mistake[]} */
  #mistakes = [];

  /**
   * @param {HTMLElement} place
   * @param {Listener} listener
   */
  constructor(place, listener) {
    const root = place.attachShadow({ mode: 'open' });
    const inside = element('div');
    inside.style.height = '100%';
    root.append(inside);
    this.extensions = this.#extensions(listener);
    this.view = new EditorView({ root, parent: inside, state: this.#fresh('', true) });
    // CodeMirror itself ignores a resize shortly after an update, which would misalign the numbers of wrapped lines.
    new ResizeObserver(() => this.view.requestMeasure()).observe(this.view.contentDOM);
  }

  get text() {
    return this.view.state.doc.toString();
  }

  /**
   * Shows a program and restores its undo history.
   *
   * @param {string} name
   * @param {string} text
   * @param {boolean} readOnly
   */
  open(name, text, readOnly) {
    this.#left.set(this.#name, this.view.state);
    const before = this.#left.get(name);
    this.#name = name;
    this.#remarks = [];
    this.#mistakes = [];
    this.view.setState(before ?? this.#fresh(text, readOnly));
    this.replace(text);
  }

  /** Replaces the text with the version written by another program; undoable. @param {string} text */
  replace(text) {
    const { doc } = this.view.state;
    const change = difference(doc.toString(), text);
    if (change) {
      this.view.dispatch({ changes: change, annotations: Transaction.userEvent.of('input.outside') });
    }
  }

  /** @param {readonly Remark[]} remarks the compiler's remarks */
  setRemarks(remarks) {
    this.#remarks = remarks;
    const { state } = this.view;
    const marks = remarks.flatMap((remark) => {
      const range = rangeOf(remark, state.doc.length);
      const severity = /** @type {'error' | 'warning'} */ (remark.serious ? 'error' : 'warning');
      return range ? [{ ...range, severity, message: [remark.text, remark.hint].filter(Boolean).join('\n') }] : [];
    });
    this.view.dispatch(setDiagnostics(state, marks));
    this.#say();
  }

  /** @param {readonly Mistake[]} mistakes errors reported by the running program */
  setMistakes(mistakes) {
    this.#mistakes = mistakes;
    this.#say();
  }

  /** @param {Array<{line: number, text: string}>} values */
  setValues(values) {
    showValues(this.view, values);
  }

  /** @param {number} line starting at 1 */
  goTo(line) {
    const { doc } = this.view.state;
    const { from } = doc.line(Math.max(1, Math.min(doc.lines, line)));
    this.view.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: 'center' }) });
    this.view.focus();
  }

  /** Reindents all lines. */
  indentAll() {
    const { state } = this.view;
    const { head } = state.selection.main;
    this.view.dispatch({ selection: { anchor: 0, head: state.doc.length } });
    indentSelection(this.view);
    this.view.dispatch({ selection: { anchor: Math.min(head, this.view.state.doc.length) } });
  }

  #say() {
    const compiler = this.#remarks
      .filter(({ line }) => line > 0)
      .map(({ line, serious, text, hint }) => ({ line, kind: serious ? 'error' : 'warning', text, hint, ran: false }));
    const robot = this.#mistakes.map(({ line, text }) => ({ line, kind: 'error', text, hint: '', ran: true }));
    showMessages(
      this.view,
      /** @type {import('./said-lines.js').Said[]} */ ([...compiler.slice(0, MAX_SAID), ...robot]),
    );
  }

  /** @param {string} text @param {boolean} readOnly */
  #fresh(text, readOnly) {
    const rule = this.#readOnly.of([EditorState.readOnly.of(readOnly), EditorView.editable.of(true)]);
    return EditorState.create({ doc: text, extensions: [this.extensions, rule] });
  }

  /** @param {Listener} listener */
  #extensions({ changed, complete, save, run }) {
    const act = (/** @type {() => void} */ action) => () => (action(), true);
    const own = [
      { key: 'Mod-s', run: act(save), preventDefault: true },
      { key: 'Mod-Enter', run: act(run), preventDefault: true },
      { key: 'Tab', run: indentMore, shift: indentLess },
      { key: 'Shift-Alt-f', run: act(() => this.indentAll()) },
    ];
    return [
      GHOST_TEXT,
      ...[lineNumbers(), lintGutter(), highlightActiveLine(), highlightActiveLineGutter(), drawSelection()],
      ...[
        history(),
        indentOnInput(),
        bracketMatching(),
        closeBrackets(),
        highlightSelectionMatches({ wholeWords: true }),
      ],
      ...[search({ top: true }), java(), indentUnit.of('    '), EditorState.tabSize.of(4)],
      autocompletion({ override: [complete], icons: false }),
      keymap.of([
        ...closeBracketsKeymap,
        ...completionKeymap,
        ...own,
        ...defaultKeymap,
        ...searchKeymap,
        ...historyKeymap,
      ]),
      EditorView.contentAttributes.of({
        tabindex: '0',
        'aria-label': 'Program. Press Escape, then Tab, to leave the editor.',
      }),
      EditorView.updateListener.of((update) => update.docChanged && changed()),
      ...[LOOK, SAID_LINES],
    ];
  }
}

/** @param {string} before @param {string} after @returns {{from: number, to: number, insert: string} | undefined} */
function difference(before, after) {
  if (before === after) {
    return undefined;
  }
  const length = Math.min(before.length, after.length);
  let start = 0;
  while (start < length && before[start] === after[start]) {
    start += 1;
  }
  let end = 0;
  while (end < length - start && before[before.length - 1 - end] === after[after.length - 1 - end]) {
    end += 1;
  }
  return { from: start, to: before.length - end, insert: after.slice(start, after.length - end) };
}
