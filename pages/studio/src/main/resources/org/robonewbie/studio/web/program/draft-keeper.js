/** What is typed and not saved, kept beside the file, so that neither a crash nor another window takes it away. */
import { isOpenToChange, isUnsaved, written } from '../state/program/documents.js';

const DRAFT_MILLISECONDS = 400;

/**
 * @typedef {object} Desk
 * @property {import('../state/program/documents.js').OpenFile | undefined} file that is open
 * @property {{text: string}} editor
 * @property {import('./program-service.js').ProgramService} service
 */

export class DraftKeeper {
  #timer = 0;
  #isKept = true;
  /** Of the draft that this window has read or written, empty if there is none. Another window may have written another one. */
  #version = '';
  /** One after the other, since each has to know what the one before made. @type {Promise<unknown>} */
  #last = Promise.resolve();

  /** @param {Desk} desk @param {(action: () => Promise<unknown>) => void} attempt @param {() => void} taken another window has unsaved work too */
  constructor(desk, attempt, taken) {
    this.desk = desk;
    this.attempt = attempt;
    this.taken = taken;
  }

  /** @returns {boolean} whether something is lost if the page is closed now */
  get isAtRisk() {
    return !this.#isKept;
  }

  /** Another file is open. @param {string} version of its draft, empty if it has none */
  begin(version) {
    clearTimeout(this.#timer);
    this.#version = version;
    this.#isKept = true;
  }

  /** The open file was saved; a draft with the same text went with it. */
  saved() {
    this.begin('');
  }

  /** The next draft replaces that of another window. @param {string} version of that one */
  replace(version) {
    this.#version = version;
  }

  /** Keeps what is there in a moment, if nothing else is typed meanwhile. */
  keepSoon() {
    this.#isKept = !isUnsaved(this.desk.file, this.desk.editor.text);
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => this.attempt(() => this.keep()), DRAFT_MILLISECONDS);
  }

  /**
   * Keeps what is there now.
   *
   * @returns {Promise<boolean>} false if another window has unsaved work on the same file
   * @throws {Error} if there is no room for it
   */
  keep() {
    clearTimeout(this.#timer);
    const now = this.#last.catch(() => {}).then(() => this.#keep());
    this.#last = now;
    return now;
  }

  async #keep() {
    const { file, editor, service } = this.desk;
    const { text } = editor;
    if (!file || !isOpenToChange(file)) {
      return true;
    }
    try {
      if (isUnsaved(file, text)) {
        this.#version = await service.writeDraft(file.path, written(file, text), this.#version);
      } else if (this.#version !== '') {
        await service.removeDraft(file.path, this.#version);
        this.#version = '';
      }
    } catch (error) {
      this.#isKept = false;
      if (/** @type {any} */ (error).status !== 409) {
        throw error;
      }
      this.taken();
      return false;
    }
    this.#isKept = text === editor.text;
    return true;
  }
}
