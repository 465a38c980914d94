/** Theme of the code editor: uses the page's colours, and therefore the page's light or dark theme. */
import { Decoration, EditorView, HighlightStyle, syntaxHighlighting, tags } from 'codemirror';

const theme = EditorView.theme({
  '&': { height: '100%', color: 'var(--ink)', backgroundColor: 'var(--field)', fontSize: '14px' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': {
    fontFamily: "ui-monospace, 'SF Mono', Menlo, Consolas, 'DejaVu Sans Mono', monospace",
    lineHeight: '1.5',
  },
  '.cm-content': { caretColor: 'var(--ink)' },
  '.cm-line': { paddingLeft: 'calc(6px + var(--hang, 0ch))', textIndent: 'calc(-1 * var(--hang, 0ch))' },
  '.cm-cursor': { borderLeftColor: 'var(--ink)' },
  '.cm-gutters': { color: 'var(--faint)', backgroundColor: 'var(--field)', border: 'none' },
  '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'var(--press)' },
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': {
    backgroundColor: 'var(--code-selection)',
  },
  '.cm-matchingBracket, &.cm-focused .cm-matchingBracket': { backgroundColor: 'var(--code-bracket)' },
  '.cm-selectionMatch': { backgroundColor: 'var(--press)' },
  '.cm-tooltip, .cm-panels': {
    color: 'var(--ink)',
    backgroundColor: 'var(--code-tip)',
    border: '1px solid var(--edge)',
    borderRadius: '6px',
  },
  '.cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]': {
    color: 'var(--on-accent)',
    backgroundColor: 'var(--accent)',
  },
  '.cm-tooltip-autocomplete .cm-completionDetail': { marginLeft: '1em', fontStyle: 'normal', opacity: '0.75' },
  '.cm-completionInfo': { maxWidth: '30em', padding: '6px 10px', whiteSpace: 'pre-wrap', fontFamily: 'inherit' },
  '.cm-said': {
    // As wide as the visible part of the editor, with wrapped text, so that long remarks do not widen it.
    boxSizing: 'border-box',
    width: '0',
    minWidth: '100%',
    padding: '2px 10px 4px',
    fontFamily: 'system-ui, sans-serif',
    fontSize: '13px',
    lineHeight: '1.35',
    whiteSpace: 'pre-wrap',
    backgroundColor: 'var(--press)',
    borderLeft: '3px solid var(--trouble)',
  },
  '.cm-said[data-kind=warning]': { borderLeftColor: 'var(--warning)' },
  '.cm-said strong': { fontWeight: '600', color: 'var(--trouble)' },
  '.cm-said[data-kind=warning] strong': { color: 'var(--warning)' },
  '.cm-failed': { backgroundColor: 'var(--code-failed)' },
  '.cm-value': { marginLeft: '2em', color: 'var(--accent)', fontStyle: 'italic' },
});

const colours = HighlightStyle.define([
  { tag: [tags.keyword, tags.modifier, tags.controlKeyword], color: 'var(--code-keyword)', fontWeight: '600' },
  { tag: [tags.string, tags.character], color: 'var(--code-text)' },
  { tag: [tags.number, tags.bool, tags.null], color: 'var(--code-number)' },
  { tag: [tags.lineComment, tags.blockComment], color: 'var(--faint)', fontStyle: 'italic' },
  { tag: [tags.typeName, tags.className], color: 'var(--code-type)' },
  { tag: tags.definition(tags.variableName), color: 'var(--ink)' },
  { tag: [tags.annotation, tags.meta], color: 'var(--code-number)' },
]);

/** Indents the continuation of a wrapped line more deeply than its beginning, by whole tabs so that the tab stops stay in place. */
const hangingIndent = EditorView.decorations.of(({ state: { doc, tabSize }, viewport }) => {
  const ranges = [];
  for (let at = viewport.from; at <= viewport.to;) {
    const { from, to, text } = doc.lineAt(at);
    const hang = (Math.ceil(text.search(/\S|$/) / tabSize) + 1) * tabSize;
    ranges.push(Decoration.line({ attributes: { style: `--hang: ${hang}ch` } }).range(from));
    at = to + 1;
  }
  return Decoration.set(ranges);
});

export const LOOK = [theme, syntaxHighlighting(colours), EditorView.lineWrapping, hangingIndent];
