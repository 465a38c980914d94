/** Asks the person for a word in a small dialog. */
import { element } from '../panels/elements.js';

/**
 * @param {object} question
 * @param {string} question.title
 * @param {string} question.label
 * @param {string} question.value
 * @param {string} question.action text of the button
 * @param {RegExp} question.pattern what is possible
 * @param {string} question.hint what is possible, for people
 * @returns {Promise<string | undefined>} the answer, or undefined if the person wants nothing
 */
export function ask({ title, label, value, action, pattern, hint }) {
  const input = element('input', { type: 'text', value, 'aria-label': label, id: 'answer' });
  const accept = element('button', { type: 'submit', class: 'primary', id: 'accept' }, action);
  const cancel = element('button', { type: 'button' }, 'Cancel');
  const form = element(
    'form',
    { method: 'dialog' },
    element('h2', {}, title),
    element('label', {}, element('span', {}, label), input),
    element('p', { class: 'faint' }, hint),
    element('div', { class: 'dialog-buttons' }, cancel, accept),
  );
  const dialog = element('dialog', { class: 'question', 'aria-label': title }, form);
  document.body.append(dialog);
  input.addEventListener('input', () => {
    accept.disabled = !pattern.test(input.value.trim());
  });
  return new Promise((resolve) => {
    cancel.addEventListener('click', () => dialog.close());
    dialog.addEventListener('close', () => {
      dialog.remove();
      resolve(dialog.returnValue === 'yes' ? input.value.trim() : undefined);
    });
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      if (pattern.test(input.value.trim())) {
        dialog.close('yes');
      }
    });
    dialog.showModal();
    input.select();
  });
}

/** @param {string} value @returns {Promise<string | undefined>} */
export function askName(value) {
  return ask({
    title: 'Save motion',
    label: 'Name',
    value,
    action: 'Save',
    pattern: /^[A-Za-z0-9_-][A-Za-z0-9._ -]{0,79}$/,
    hint: 'Letters, digits, blanks, dots, - and _. Agents play it by this name.',
  });
}

/** @returns {Promise<File | undefined>} a file that the person chooses */
export function askFile(/** @type {string} */ accept) {
  const input = element('input', { type: 'file', accept });
  return new Promise((resolve) => {
    input.addEventListener('change', () => resolve(input.files?.[0]));
    input.addEventListener('cancel', () => resolve(undefined));
    input.click();
  });
}
