/** Unsaved work, kept on the disk while one works, so that neither a crash nor another motion takes it away. */
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
  /** Drafts are written one after the other: two at once would give one motion two names. @type {Promise<boolean>} */
  #last = Promise.resolve(true);

  /**
   * @param {MotionFiles} files
   * @param {object} editor
   * @param {() => EditorState} editor.state
   * @param {() => MotionList} editor.list
   * @param {(draft: string) => Promise<void>} editor.named the motion without a name has a place among the drafts now
   * @param {(text: string) => void} editor.note
   */
  constructor(files, editor) {
    this.files = files;
    this.editor = editor;
    /** The document that is on the disk as a draft. @type {object | undefined} */
    this.kept = undefined;
  }

  /** @param {EditorState} state @returns {boolean} whether work is shown that is neither in its file nor a draft */
  isAtRisk(state) {
    return isWork(state) && documentOf(state) !== this.kept;
  }

  /** Keeps what is there in a moment, if nothing else is done meanwhile. */
  keepSoon() {
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => this.keep(), DRAFT_MILLISECONDS);
  }

  /** Keeps what is there now. @returns {Promise<boolean>} whether that was possible, so that another motion may be shown */
  keep() {
    clearTimeout(this.#timer);
    this.#last = this.#last.then(async () => {
      try {
        await this.#keep();
        return true;
      } catch {
        this.editor.note('Unsaved work cannot be kept just now. It stays in this page; save it soon.');
        return false;
      }
    });
    return this.#last;
  }

  /** The first free number: a draft never replaces that of another motion, nor that of another window. */
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

  /** @param {string} known empty for a motion that was never kept @param {ReturnType<typeof documentOf>} document */
  async #write(known, document) {
    const name = known || (await this.newName());
    await this.files.writeDraft(name, document);
    this.kept = document;
    if (known === '') {
      await this.editor.named(name);
    }
  }
}

/** @param {EditorState} state @returns {boolean} whether there is something that a person has made and not saved */
function isWork(state) {
  const isTouched = state.history.past.length > 0 || state.draft !== '';
  return isTouched && framesOf(state).length > 0 && isUnsaved(state);
}

/** @param {MotionList} list @returns {string[]} names of the drafts of motions that were never saved */
export function namelessDrafts({ own, drafts, library }) {
  const files = new Set([...own.map(({ name }) => name), ...library]);
  return drafts.map(({ name }) => name).filter((name) => !files.has(name));
}
