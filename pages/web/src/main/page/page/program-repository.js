/** The user's programs and their unsaved drafts. */
import { isProgramPath } from '../state/file-name.js';
import { freeName } from '../state/program/documents.js';
import { fileName } from '../state/program/remarks.js';
import { BrowserRepository } from './browser-repository.js';

/** @typedef {{path: string, before: string}} Shared a program opened from a link, and the one that was open before */

const SHARED_NAME = 'Shared.java';

/** @param {string} path path from a link @returns {string} a valid program name without folders */
function plainName(path) {
  const name = fileName(path.replaceAll('\\', '/'));
  return isProgramPath(name) ? name : SHARED_NAME;
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

  /** @returns {Shared[]} programs opened from links that have been neither saved nor discarded yet */
  get shared() {
    const drafts = new Set(this.drafts.map(({ path }) => path));
    return this.#shared.list
      .filter(({ path }) => drafts.has(path))
      .map(({ path }) => ({ path, before: this.#shared.read(path) ?? '' }));
  }

  /** @returns {Map<string, string>} texts of all saved files */
  get texts() {
    return new Map(this.own.map(({ path }) => [path, this.#own.read(path) ?? '']));
  }

  /** @param {'own' | 'draft'} kind @param {string} path @returns {string | null} */
  read(kind, path) {
    return (kind === 'own' ? this.#own : this.#drafts).read(path);
  }

  /** @param {string} path @param {string} text @param {string} known version read by the writer @returns {Response} */
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
    this.#drafts.remove(path); // not enough space for file and draft
    try {
      return this.#overwritten(path, text, known, true);
    } catch (full) {
      this.#drafts.write(path, text);
      throw full;
    }
  }

  /** @param {string} path @param {string} text @param {string} known @param {boolean} isOfWriter whether the draft contains this text */
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
   * Creates a file.
   *
   * @param {string} path
   * @param {string} text
   * @returns {boolean} false if a file or draft with this name exists
   */
  add(path, text) {
    return this.#drafts.read(path) === null && this.#own.add(path, text);
  }

  /** @param {string} path @param {string} text @param {string | null} known version of the draft read by the writer @returns {Response} */
  writeDraft(path, text, known) {
    return this.#drafts.overwrite(path, text, known);
  }

  /**
   * Adds a program from a link to the existing ones, which are not changed.
   *
   * @param {string} path path from the link
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

  /** @param {string} path @param {string | null} [known] version to remove; any other is kept */
  removeDraft(path, known) {
    this.#drafts.remove(path, known);
    if (this.#drafts.read(path) === null) {
      this.#shared.remove(path);
    }
  }
}
