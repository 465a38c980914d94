/** Dialog that compares the saved versions of a program with the text in the editor. */
import { showDialog } from '../panels/questions.js';
import { button, choice, element } from '../panels/elements.js';
import { changedLines, lineDiff, nearChanges } from '../state/program/line-diff.js';
import { ageText } from '../state/program/versions.js';

/**
 * @typedef {import('../state/program/line-diff.js').DiffLine} DiffLine
 * @typedef {import('../state/program/versions.js').Version} Version
 */

const TAGS = /** @type {const} */ ({ ' ': 'span', '−': 'del', '+': 'ins' });

/**
 * @param {string} name name of the program
 * @param {readonly Version[]} versions newest first; at least one
 * @param {string} text text in the editor
 * @returns {Promise<string | undefined>} the text to restore, or undefined if the dialog was closed
 */
export function showVersions(name, versions, text) {
  const diffs = versions.map((version) => lineDiff(version.text, text));
  const comparison = element('pre', { tabindex: '0', role: 'region', 'aria-label': 'Comparison' });
  const restore = button('Restore', 'Puts this version into the editor and saves it', () => dialog.close('restore'), {
    class: 'primary',
    id: 'restore-version',
  });
  const show = (/** @type {string} */ chosen) => {
    comparison.replaceChildren(...nearChanges(diffs[Number(chosen)]).map(row));
    restore.disabled = versions[Number(chosen)].text === text;
  };
  const list = versionList(versions, diffs, show);
  const close = button('Close', '', () => dialog.close());
  const title = `Saved versions of ${name}`;
  const buttons = element('div', { class: 'dialog-buttons' }, close, restore);
  const content = [element('h2', {}, title), list, element('div', {}, legend(), comparison), buttons];
  const dialog = showDialog(title, element('div', { class: 'versions' }, ...content));
  const newest = versions.findIndex((version) => version.text !== text);
  list.value = String(Math.max(0, newest));
  show(list.value);
  list.focus();
  return new Promise((resolve) => {
    dialog.addEventListener('close', () =>
      resolve(dialog.returnValue === 'restore' ? versions[Number(list.value)].text : undefined),
    );
  });
}

/** @param {readonly Version[]} versions @param {readonly DiffLine[][]} diffs @param {(index: string) => void} chosen */
function versionList(versions, diffs, chosen) {
  const now = Date.now();
  const entries = versions.map(
    ({ time }, i) => /** @type {const} */ ([String(i), `${ageText(time, now)}, ${changeText(changedLines(diffs[i]))}`]),
  );
  const list = choice({ size: '12', 'aria-label': 'Saved versions', id: 'versions' }, entries, chosen);
  versions.forEach(({ time }, i) => {
    list.options[i].title = time === 0 ? 'Saved by another program or window' : new Date(time).toLocaleString();
  });
  return list;
}

const legend = () =>
  element('p', {}, element('del', {}, '− only in this version'), element('ins', {}, '+ only in the editor'));

/** @param {number} lines */
const changeText = (lines) => (lines === 0 ? 'same as now' : lines === 1 ? '1 line differs' : `${lines} lines differ`);

/** @param {DiffLine | undefined} line */
function row(line) {
  return line ? element(TAGS[line.sign], {}, `${line.sign} ${line.text}`) : element('span', { class: 'faint' }, '⋯');
}
