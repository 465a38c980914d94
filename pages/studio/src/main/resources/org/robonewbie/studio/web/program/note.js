import { element } from '../panels/elements.js';

/** Creates a note above the program. @param {string} text @param {...HTMLElement} actions @returns {HTMLElement} */
export function note(text, ...actions) {
  return element('div', { class: 'program-note', role: 'status' }, element('p', {}, text), ...actions);
}
