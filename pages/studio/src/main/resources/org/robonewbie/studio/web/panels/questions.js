/** Small modal dialogs that ask a question, or report something too long for a note. */
import { button, choice, element } from './elements.js';
import { composedName, nameProblem } from '../state/file-name.js';

/**
 * @param {object} question
 * @param {string} question.title
 * @param {string} question.label
 * @param {string} question.value
 * @param {string} question.action text of the button
 * @param {(answer: string) => string} question.problem error message for an answer, empty if it is valid
 * @param {string} question.hint description of valid answers
 * @returns {Promise<string | undefined>} the answer, or undefined if the dialog was cancelled
 */
export function ask({ title, label, value, action, problem, hint }) {
  const input = element('input', { type: 'text', value, 'aria-label': label, id: 'answer' });
  const answer = opened({ title, label, action, hint }, input, () => problem(input.value.trim()));
  input.select();
  return answer;
}

/**
 * @param {object} question
 * @param {string} question.title
 * @param {string} question.label
 * @param {string} question.action text of the button
 * @param {string} question.hint
 * @param {ReadonlyArray<readonly [value: string, text: string]>} question.entries
 * @returns {Promise<string | undefined>} the value of the chosen entry, or undefined if the dialog was cancelled
 */
export function askChoice({ entries, ...question }) {
  const list = choice({ 'aria-label': question.label, id: 'answer' }, entries, () => {});
  const answer = opened(question, list, () => '');
  list.focus();
  return answer;
}

/**
 * @param {{title: string, label: string, action: string, hint: string}} question
 * @param {HTMLInputElement | HTMLSelectElement} field
 * @param {() => string} problem
 * @returns {Promise<string | undefined>}
 */
function opened({ title, label, action, hint }, field, problem) {
  const accept = element('button', { type: 'submit', class: 'primary', id: 'accept' }, action);
  const wrong = element('p', { class: 'wrong', role: 'status', id: 'answer-problem' });
  const form = element(
    'form',
    { method: 'dialog' },
    element('h2', {}, title),
    element('label', {}, element('span', {}, label), field),
    element('p', { class: 'faint' }, hint),
    wrong,
    element(
      'div',
      { class: 'dialog-buttons' },
      button('Cancel', '', () => dialog.close()),
      accept,
    ),
  );
  const dialog = showDialog(title, form);
  field.addEventListener('input', () => {
    wrong.textContent = problem();
    accept.disabled = wrong.textContent !== '';
  });
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    if (problem() === '') {
      dialog.close('yes');
    }
  });
  return new Promise((resolve) => {
    dialog.addEventListener('close', () => resolve(dialog.returnValue === 'yes' ? field.value.trim() : undefined));
  });
}

/** Shows a modal dialog. @param {string} title @param {HTMLElement} content */
export function showDialog(title, content) {
  const dialog = element('dialog', { class: 'question', 'aria-label': title }, content);
  document.body.append(dialog);
  dialog.addEventListener('close', () => dialog.remove());
  dialog.showModal();
  return dialog;
}

/**
 * Reports several findings, each with a link to its location.
 *
 * @param {string} title
 * @param {string} text
 * @param {Array<{text: string, go: () => void}>} places
 */
export function showFindings(title, text, places) {
  const rows = places.map((place) =>
    element(
      'li',
      {},
      button(place.text, 'Go there', () => (dialog.close(), place.go())),
    ),
  );
  const close = button('Close', '', () => dialog.close(), { class: 'primary' });
  const content = element(
    'div',
    {},
    element('h2', {}, title),
    element('p', {}, text),
    element('ul', { class: 'places' }, ...rows),
    element('div', { class: 'dialog-buttons' }, close),
  );
  const dialog = showDialog(title, content);
}

/** @param {string} value @returns {Promise<string | undefined>} */
export async function askName(value) {
  const name = await ask({
    title: 'Save motion',
    label: 'Name',
    value,
    action: 'Save',
    problem: (answer) => nameSentence(composedName(answer)),
    hint: 'Agents play the motion by this name.',
  });
  return name === undefined ? undefined : composedName(name);
}

/** @param {string} name @returns {string} */
function nameSentence(name) {
  const problem = nameProblem(name);
  return problem === '' ? '' : `The name ${problem}.`;
}

/** @returns {Promise<File | undefined>} the chosen file */
export function askFile(/** @type {string} */ accept) {
  const input = element('input', { type: 'file', accept });
  return new Promise((resolve) => {
    input.addEventListener('change', () => resolve(input.files?.[0]));
    input.addEventListener('cancel', () => resolve(undefined));
    input.click();
  });
}
