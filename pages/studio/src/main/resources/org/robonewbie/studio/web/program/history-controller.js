/** Keeps the last saved versions of each program, and restores them. */
import { button } from '../panels/elements.js';
import { isOpenToChange, isUnsaved } from '../state/program/documents.js';
import { fileName } from '../state/program/remarks.js';
import { MAX_VERSIONS, withVersion } from '../state/program/versions.js';
import { showVersions } from './versions-dialog.js';

/**
 * @typedef {import('../state/program/documents.js').OpenFile} OpenFile
 * @typedef {import('../state/program/versions.js').Version} Version
 */

export class HistoryController {
  /** Serialises the writes, because each one needs the result of the previous one. */
  #last = Promise.resolve();

  /** @param {any} room */
  constructor(room) {
    this.room = room;
    this.button = button(
      'History',
      `Shows the last ${MAX_VERSIONS} saved versions`,
      () => room.attempt(() => this.#open()),
      { id: 'program-history' },
    );
    room.foot.append(this.button);
  }

  draw() {
    this.button.hidden = !isOpenToChange(this.room.files.file);
  }

  /** Adds a saved version without delaying or preventing the save. @param {OpenFile} before @param {string} text */
  keep(before, text) {
    const replaced = before.version === '' ? [] : [{ time: 0, text: before.saved }];
    const saved = [...replaced, { time: Date.now(), text }];
    this.#last = this.#last.then(() => this.#add(before.path, saved)).catch(() => {});
  }

  /** @param {string} path @param {Version[]} saved */
  async #add(path, saved) {
    const before = await this.#read(path);
    const after = saved.reduce(withVersion, before);
    if (after !== before) {
      await this.room.service.writeHistory(path, after);
    }
  }

  /** @param {string} path @returns {Promise<Version[]>} the saved versions; empty if they are unreadable */
  #read(path) {
    return this.room.service.history(path).catch(() => []);
  }

  async #open() {
    const { files, editor, surroundings } = this.room;
    await this.#last;
    const { path } = files.file;
    const versions = await this.#read(path);
    if (versions.length === 0) {
      surroundings.note(`${fileName(path)} has no saved versions yet. Each Save adds one.`);
      return;
    }
    const text = await showVersions(fileName(path), versions.reverse(), editor.text);
    if (text !== undefined && path === files.file.path) {
      await this.#restore(text);
    }
  }

  /** Saves unsaved text first, so that it is also kept as a version. @param {string} text */
  async #restore(text) {
    const { files, editor } = this.room;
    if (!isUnsaved(files.file, editor.text) || (await files.save())) {
      editor.replace(text);
      await this.room.save();
    }
  }
}
