/** Shows messages from the compiler and the robot below the lines to which they refer, and values at the ends of lines. */
import { Decoration, EditorView, StateEffect, StateField, WidgetType } from 'codemirror';
import { element } from '../panels/elements.js';

/**
 * @typedef {{line: number, kind: 'error' | 'warning', text: string, hint: string, ran: boolean}} Said `ran` if it was reported at run time
 * @typedef {{line: number, text: string}} Value
 */

/** @type {import('@codemirror/state').StateEffectType<readonly Said[]>} */
const setSaid = StateEffect.define();

/** @type {import('@codemirror/state').StateEffectType<readonly Value[]>} */
const setValues = StateEffect.define();

/** Shows an element in the text. */
class ElementWidget extends WidgetType {
  /** @param {HTMLElement} shown */
  constructor(shown) {
    super();
    this.shown = shown;
  }

  /** @param {ElementWidget} other */
  eq(other) {
    return other.shown.isEqualNode(this.shown);
  }

  toDOM() {
    return /** @type {HTMLElement} */ (this.shown.cloneNode(true));
  }
}

/** @param {Said} said */
function saidBelow({ kind, text, hint }) {
  const more = hint === '' ? '' : `\n${hint}`;
  return new ElementWidget(element('div', { class: 'cm-said', 'data-kind': kind }, element('strong', {}, text), more));
}

/**
 * @template T
 * @param {import('@codemirror/state').StateEffectType<readonly T[]>} effect
 * @param {(item: T, line: import('@codemirror/state').Line) => import('@codemirror/state').Range<import('@codemirror/view').Decoration>[]} shown
 */
function fieldFor(effect, shown) {
  return StateField.define({
    create: () => Decoration.none,
    update(before, transaction) {
      const change = transaction.effects.find((each) => each.is(effect));
      if (!change) {
        return before.map(transaction.changes);
      }
      const { doc } = transaction.state;
      const items = /** @type {Array<T & {line: number}>} */ (change.value).filter(({ line }) => line <= doc.lines);
      return Decoration.set(
        items.flatMap((item) => shown(item, doc.line(Math.max(1, item.line)))),
        true,
      );
    },
    provide: (field) => EditorView.decorations.from(field),
  });
}

export const SAID_LINES = [
  fieldFor(setSaid, (said, line) => [
    ...(said.ran ? [Decoration.line({ class: 'cm-failed' }).range(line.from)] : []),
    Decoration.widget({ widget: saidBelow(said), block: true, side: 1 }).range(line.to),
  ]),
  fieldFor(setValues, ({ text }, line) => {
    const widget = new ElementWidget(element('span', { class: 'cm-value' }, `= ${text}`));
    return [Decoration.widget({ widget, side: 1 }).range(line.to)];
  }),
];

/** @param {EditorView} view @param {readonly Said[]} said */
export function showMessages(view, said) {
  view.dispatch({ effects: setSaid.of(said) });
}

/** @param {EditorView} view @param {readonly Value[]} values */
export function showValues(view, values) {
  view.dispatch({ effects: setValues.of(values) });
}
