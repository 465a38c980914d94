/** List of all programs that can be opened. */
import { element } from '../panels/elements.js';

/**
 * @param {HTMLSelectElement} choice
 * @param {import('./program-service.js').ProgramList} list
 * @param {readonly string[]} exercises name and title, separated by a tab
 * @param {import('../state/program/documents.js').OpenFile | undefined} file the open file
 */
export function fillChoice(choice, list, exercises, file) {
  const known = list.own.map(({ path }) => path);
  const others = list.drafts.map(({ path }) => path).filter((path) => !known.includes(path));
  const paths = [...known, ...others];
  const unnamed = file?.kind === 'own' && !paths.includes(file.path) ? [file.path] : [];
  choice.replaceChildren(
    group('Your programs', 'own', [...unnamed, ...paths]),
    group('Exercises', 'exercise', exercises),
    group('Examples, to read and copy', 'example', list.examples),
  );
}

/** @param {string} label @param {string} kind @param {readonly string[]} names */
function group(label, kind, names) {
  const entries = names.map((name) => {
    const [value, text] = name.includes('\t') ? name.split('\t') : [name, name.replace(/^src\/main\/java\//, '')];
    return element('option', { value: `${kind} ${value}` }, text);
  });
  return element('optgroup', { label }, ...entries);
}
