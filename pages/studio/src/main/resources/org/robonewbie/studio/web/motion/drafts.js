/** Autosaves unsaved work as drafts on disk, so that it survives a crash or the opening of another motion. */
import { documentOf, framesOf, isUnsaved } from '../state/motion/editor-state.js';

/**
 * @typedef {import('../state/motion/editor-state.js').EditorState} EditorState
 * @typedef {import('./motion-files.js').MotionFiles} MotionFiles
 * @typedef {import('./motion-files.js').MotionList} MotionList
 */

const DRAFT_MILLISECONDS = 400;
const NAMELESS = 'new motion';

export class Drafts {
  #timer = 0;
  /** Serialises the writes, because two concurrent writes would store one motion under two names. @type {Promise<boolean>} */
  #last = Promise.resolve(true);

  /**
   * @param {MotionFiles} files
   * @param {object} editor
   * @param {() => EditorState} editor.state
   * @param {() => MotionList} editor.list
   * @param {(draft: string) => Promise<void>} editor.named called when an untitled motion has been stored as this draft
   * @param {(text: string) => void} editor.note
   */
  constructor(files, editor) {
    this.files = files;
    this.editor = editor;
    /** The document stored in the draft on the disk. @type {object | undefined} */
    this.kept = undefined;
  }

  /**
   * @param {EditorState} state @returns {boolean} whether the open motion has changes that are stored neither in its file nor in a draft
   */
  isAtRisk(state) {
    return isWork(state) && documentOf(state) !== this.kept;
  }

  /** Saves a draft after a short idle time. */
  keepSoon() {
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => this.keep(), DRAFT_MILLISECONDS);
  }

  /** Saves a draft now. @returns {Promise<boolean>} whether it succeeded and another motion may be opened */
  keep() {
    clearTimeout(this.#timer);
    this.#last = this.#last.then(async () => {
      try {
        await this.#keep();
        return true;
      } catch {
        this.editor.note('The draft could not be saved. Your work is still on this page; save it soon.');
        return false;
      }
    });
    return this.#last;
  }

  /** Chooses a name with the lowest free number, so that no draft of another motion or window is replaced. */
  async newName() {
    const { own, drafts } = await this.files.list();
    const taken = new Set([...own, ...drafts].map(({ name }) => name));
    let number = 1;
    while (taken.has(`${NAMELESS} ${number}`)) {
      number += 1;
    }
    return `${NAMELESS} ${number}`;
  }

  async #keep() {
    const state = this.editor.state();
    const name = state.name || state.draft;
    if (isWork(state)) {
      await this.#write(name, documentOf(state));
    } else if (this.editor.list().drafts.some((draft) => draft.name === name)) {
      await this.files.removeDraft(name);
    }
  }

  /** @param {string} known empty for a motion that has never been stored @param {ReturnType<typeof documentOf>} document */
  async #write(known, document) {
    const name = known || (await this.newName());
    await this.files.writeDraft(name, document);
    this.kept = document;
    if (known === '') {
      await this.editor.named(name);
    }
  }
}

/** @param {EditorState} state @returns {boolean} whether there are unsaved changes made by the user */
function isWork(state) {
  const isTouched = state.history.past.length > 0 || state.draft !== '';
  return isTouched && framesOf(state).length > 0 && isUnsaved(state);
}

/** @param {MotionList} list @returns {string[]} names of the drafts of untitled motions */
export function namelessDrafts({ own, drafts, library }) {
  const files = new Set([...own.map(({ name }) => name), ...library]);
  return drafts.map(({ name }) => name).filter((name) => !files.has(name));
}
