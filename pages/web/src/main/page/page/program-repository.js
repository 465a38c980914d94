/** The programs of the person, and what of them is not saved yet. */
import { freeName } from '../state/program/documents.js';
import { fileName } from '../state/program/remarks.js';
import { BrowserRepository } from './browser-repository.js';

/** @typedef {{path: string, before: string}} Shared a program that came with a link, and the one that was open before */

const SHARED_NAME = 'Shared.java';
const CLASS_FILE = /^[\p{L}_$][\p{L}\p{N}_$]{0,79}\.java$/u;
/** What Windows takes for a device. */
const DEVICE = /^(con|prn|aux|nul|(com|lpt)\d)\./i;

/** @param {string} path as a link has it @returns {string} a name that a program can have, without folders */
function plainName(path) {
  const name = fileName(path.replaceAll('\\', '/'));
  return CLASS_FILE.test(name) && !DEVICE.test(name) ? name : SHARED_NAME;
}

export class ProgramRepository {
  #own;
  #drafts;
  #shared;

  /** @param {() => import('./page-storage.js').PageStorage} [open] */
  constructor(open) {
    this.#own = new BrowserRepository('robonewbie-page-file:', open);
    this.#drafts = new BrowserRepository('robonewbie-page-draft:', open);
    this.#shared = new BrowserRepository('robonewbie-page-shared:', open);
  }

  get own() {
    return this.#own.list;
  }

  get drafts() {
    return this.#drafts.list;
  }

  /** @returns {Shared[]} what came with links and is neither kept nor given back yet */
  get shared() {
    const drafts = new Set(this.drafts.map(({ path }) => path));
    return this.#shared.list
      .filter(({ path }) => drafts.has(path))
      .map(({ path }) => ({ path, before: this.#shared.read(path) ?? '' }));
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
    const draft = this.#drafts.read(path);
    const isOfWriter = draft === text;
    try {
      return this.#overwritten(path, text, known, isOfWriter);
    } catch (full) {
      if (!isOfWriter) {
        throw full;
      }
    }
    this.#drafts.remove(path); // file and draft have no room beside each other
    try {
      return this.#overwritten(path, text, known, true);
    } catch (full) {
      this.#drafts.write(path, text);
      throw full;
    }
  }

  /** @param {string} path @param {string} text @param {string} known @param {boolean} isOfWriter whether the draft is this text */
  #overwritten(path, text, known, isOfWriter) {
    const answer = this.#own.overwrite(path, text, known);
    if (answer.ok) {
      if (isOfWriter) {
        this.#drafts.remove(path);
      }
      this.#shared.remove(path);
    }
    return answer;
  }

  /**
   * Writes a new file.
   *
   * @param {string} path
   * @param {string} text
   * @returns {boolean} false if there is one of this name, saved or not
   */
  add(path, text) {
    return this.#drafts.read(path) === null && this.#own.add(path, text);
  }

  /** @param {string} path @param {string} text @param {string} known version of the draft that the writer has seen @returns {Response} */
  writeDraft(path, text, known) {
    return this.#drafts.overwrite(path, text, known);
  }

  /**
   * Puts a program that came with the address beside what is there. Nothing that is there is changed.
   *
   * @param {string} path as the link has it
   * @param {string} text
   * @param {string} before path of the program that was open
   * @returns {string} its path here
   */
  takeShared(path, text, before) {
    const wanted = plainName(path);
    const known = [...this.own, ...this.drafts];
    const same = known.find((each) => (this.#drafts.read(each.path) ?? this.#own.read(each.path)) === text);
    if (same) {
      return same.path;
    }
    const name = freeName(wanted, known);
    this.#drafts.write(name, text);
    this.#shared.write(name, before);
    return name;
  }

  /** @param {string} path @param {string} [known] only this version is removed */
  removeDraft(path, known) {
    this.#drafts.remove(path, known);
    if (this.#drafts.read(path) === null) {
      this.#shared.remove(path);
    }
  }
}
