/** Histories of programs in the browser's IndexedDB, where they take no space from the programs; empty if the browser stores nothing. */
import { ended, openDatabase, result } from './database.js';
import { folderOfPage } from './page-storage.js';

const TEXTS = 'histories';

export class HistoryStore {
  #database = openDatabase(`robonewbie-history ${folderOfPage()}`, (made) => made.createObjectStore(TEXTS)).catch(
    () => undefined,
  );

  /** @param {string} path @returns {Promise<string>} the history of a program, empty if there is none */
  async read(path) {
    const texts = (await this.#database)?.transaction(TEXTS).objectStore(TEXTS);
    return (texts && (await result(texts.get(path)))) ?? '';
  }

  /** @param {string} path @param {string} text */
  async write(path, text) {
    const transaction = (await this.#database)?.transaction(TEXTS, 'readwrite');
    if (transaction) {
      transaction.objectStore(TEXTS).put(text, path);
      await ended(transaction);
    }
  }
}
