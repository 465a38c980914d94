/** The programs of the person, and what of them is not saved yet. */
import { BrowserShelf } from './browser-shelf.js';

const LAST = 'robonewbie-program';

export class ProgramShelf {
  #own = new BrowserShelf('robonewbie-page-file:');
  #drafts = new BrowserShelf('robonewbie-page-draft:');

  get own() {
    return this.#own.list;
  }

  get drafts() {
    return this.#drafts.list;
  }

  /** @returns {Map<string, string>} the texts of all saved files */
  get texts() {
    return new Map(this.own.map(({ path }) => [path, this.#own.read(path) ?? '']));
  }

  /** @param {'own' | 'draft'} shelf @param {string} path @returns {string | null} */
  read(shelf, path) {
    return (shelf === 'own' ? this.#own : this.#drafts).read(path);
  }

  /** @param {string} path @param {string} text @param {string} known version of what the writer has read @returns {Response} */
  overwrite(path, text, known) {
    const answer = this.#own.overwrite(path, text, known);
    if (answer.ok) {
      this.removeDraft(path);
    }
    return answer;
  }

  /** @param {string} path @param {string} text */
  write(path, text) {
    this.#own.write(path, text);
    this.removeDraft(path);
  }

  /** @param {string} path @param {string} text */
  writeDraft(path, text) {
    this.#drafts.write(path, text);
  }

  /** Puts a program that came with the address beside what is there, and opens it first. @param {string} path @param {string} text */
  takeShared(path, text) {
    this.writeDraft(path, text);
    localStorage.setItem(LAST, JSON.stringify(path));
  }

  /** @param {string} path */
  removeDraft(path) {
    this.#drafts.remove(path);
  }
}
