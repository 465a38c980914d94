/** Messages of compiler and robot below their lines, and values at the ends of lines. */
import { Decoration, EditorView, StateEffect, StateField, WidgetType } from 'codemirror';
import { element } from '../panels/elements.js';

/**
 * @typedef {{line: number, kind: 'error' | 'warning', text: string, hint: string, ran: boolean}} Said `ran` if reported at run time
 * @typedef {{line: number, text: string}} Value
 */

/** @type {import('@codemirror/state').StateEffectType<readonly Said[]>} */
const setSaid = StateEffect.define();

/** @type {import('@codemirror/state').StateEffectType<readonly Value[]>} */
const setValues = StateEffect.define();

class SaidBelow extends WidgetType {
  /** @param {Said} said */
  constructor(said) {
    super();
    this.said = said;
  }

  /** @param {SaidBelow} other */
  eq(other) {
    return other.said.text === this.said.text && other.said.hint === this.said.hint;
  }

  toDOM() {
    const { kind, text, hint } = this.said;
    const said = element('div', { class: 'cm-said', 'data-kind': kind }, element('strong', {}, text));
    said.append(hint === '' ? '' : `\n${hint}`);
    return said;
  }
}

class ValueBehind extends WidgetType {
  /** @param {string} text */
  constructor(text) {
    super();
    this.text = text;
  }

  /** @param {ValueBehind} other */
  eq(other) {
    return other.text === this.text;
  }

  toDOM() {
    return element('span', { class: 'cm-value' }, `= ${this.text}`);
  }
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
    Decoration.widget({ widget: new SaidBelow(said), block: true, side: 1 }).range(line.to),
  ]),
  fieldFor(setValues, (value, line) => [
    Decoration.widget({ widget: new ValueBehind(value.text), side: 1 }).range(line.to),
  ]),
];

/** @param {EditorView} view @param {readonly Said[]} said */
export function showMessages(view, said) {
  view.dispatch({ effects: setSaid.of(said) });
}

/** @param {EditorView} view @param {readonly Value[]} values */
export function showValues(view, values) {
  view.dispatch({ effects: setValues.of(values) });
}
