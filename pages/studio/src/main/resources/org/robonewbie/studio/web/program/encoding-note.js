/** Shows a note above a program about the encoding of its file, if the encoding is uncertain or has changed. */
import { button, element } from '../panels/elements.js';
import { encodingNote } from '../state/decoded-text.js';
import { fileName } from '../state/program/remarks.js';

/** @typedef {import('../state/program/documents.js').OpenFile} OpenFile */

export class EncodingNote {
  place = element('div', { id: 'program-encoding' });

  /** @param {(file: OpenFile) => void} change saves the file as UTF-8 */
  constructor(change) {
    this.change = change;
  }

  /** @param {OpenFile} file @param {string} before the encoding before the last save */
  show(file, before) {
    const { encoding } = file.source;
    const inferred = encodingNote({ ...file.source, content: file.content });
    const name = fileName(file.path);
    if (file.problem !== '') {
      this.#say(`${name} cannot be decoded and is read-only: ${file.problem}`);
    } else if (encoding !== before) {
      this.#say(`${name} is now saved as ${encoding}, because ${before} cannot represent all of its characters.`);
    } else if (inferred !== '') {
      this.#say(
        `${name}: ${inferred}`,
        button('Save as UTF-8', '', () => this.change(file)),
      );
    } else {
      this.place.replaceChildren();
    }
  }

  /** @param {string} text @param {...HTMLElement} actions */
  #say(text, ...actions) {
    const note = element('div', { class: 'program-note quiet', role: 'status' }, element('p', {}, text), ...actions);
    this.place.replaceChildren(note);
  }
}
