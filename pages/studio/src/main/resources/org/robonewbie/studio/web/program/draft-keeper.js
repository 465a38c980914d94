/** Autosaves unsaved text as a draft next to the file, so that it survives a crash and edits in another window. */
import { isOpenToChange, isUnsaved, written } from '../state/program/documents.js';

const DRAFT_MILLISECONDS = 400;

/**
 * @typedef {object} DraftSource
 * @property {import('../state/program/documents.js').OpenFile | undefined} file the open file
 * @property {{text: string}} editor
 * @property {import('./program-service.js').ProgramService} service
 */

export class DraftKeeper {
  #timer = 0;
  #isKept = true;
  /** Version of the draft that this window last read or wrote, empty if there is none. Another window may have written a newer one. */
  #version = '';
  /** Serialises the writes, because each one needs the version written by the previous one. @type {Promise<unknown>} */
  #last = Promise.resolve();

  /**
   * @param {DraftSource} source
   * @param {(action: () => Promise<unknown>) => void} attempt
   * @param {() => void} taken called if another window has unsaved changes
   */
  constructor(source, attempt, taken) {
    this.source = source;
    this.attempt = attempt;
    this.taken = taken;
  }

  /** @returns {boolean} whether closing the page would lose work */
  get isAtRisk() {
    return !this.#isKept;
  }

  /** Switches to another open file. @param {string} version version of its draft, empty if there is none */
  begin(version) {
    clearTimeout(this.#timer);
    this.#version = version;
    this.#isKept = true;
  }

  /** Called after the open file has been saved, which removes a draft with the same text. */
  saved() {
    this.begin('');
  }

  /** Makes the next draft replace the one from another window. @param {string} version version of that draft */
  replace(version) {
    this.#version = version;
  }

  /** Saves a draft after a short idle time. */
  keepSoon() {
    this.#isKept = !isUnsaved(this.source.file, this.source.editor.text);
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => this.attempt(() => this.keep()), DRAFT_MILLISECONDS);
  }

  /**
   * Saves a draft now.
   *
   * @returns {Promise<boolean>} false if another window has unsaved changes to the same file
   * @throws {Error} if the storage is full
   */
  keep() {
    clearTimeout(this.#timer);
    const now = this.#last.catch(() => {}).then(() => this.#keep());
    this.#last = now;
    return now;
  }

  async #keep() {
    const { file, editor, service } = this.source;
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
