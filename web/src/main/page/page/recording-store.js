/**
 * Where this browser keeps recordings, also when the page is closed. A browser that keeps nothing, such as one that surfs in private, has
 * an empty store.
 *
 * @typedef {object} Entry what is known of a recording
 * @property {number} id when it began, in milliseconds; no two are alike
 * @property {string} name
 * @property {string} agent
 * @property {boolean} starred
 * @property {import('../replay/recording-api.js').Bookmark[]} bookmarks
 * @property {number} bytes of all pieces
 * @property {number} pieces how many there are
 * @property {number} removedAt when it was deleted, in milliseconds; 0 if it was not
 *
 * @typedef {object} Piece the next part of a recording
 * @property {Uint8Array} bytes
 * @property {boolean} isPacked whether they are packed with gzip
 * @property {string} notes what robots logged and drew meanwhile
 */

const DATABASE = 'robonewbie';
const ENTRIES = 'recordings';
const PIECES = 'pieces';

/** @template T @param {IDBRequest<T>} request @returns {Promise<T>} */
const result = (request) =>
  new Promise((done, fail) => {
    request.onsuccess = () => done(request.result);
    request.onerror = () => fail(request.error);
  });

/** @returns {Promise<IDBDatabase>} */
function open() {
  const request = indexedDB.open(DATABASE, 1);
  request.onupgradeneeded = () => {
    request.result.createObjectStore(ENTRIES, { keyPath: 'id' });
    request.result.createObjectStore(PIECES);
  };
  return result(request);
}

/** The keys of all pieces of a recording. @param {number} id */
const piecesOf = (id) => IDBKeyRange.bound([id, 0], [id, Infinity]);

export class RecordingStore {
  #database = open().catch(() => undefined);

  /** @returns {Promise<Entry[]>} */
  async entries() {
    return (await this.#do([ENTRIES], 'readonly', (store) => store(ENTRIES).getAll())) ?? [];
  }

  /** @param {Entry} entry @param {Piece} [piece] that has come with it, the last one */
  async put(entry, piece) {
    await this.#do([ENTRIES, PIECES], 'readwrite', (store) => {
      if (piece) {
        store(PIECES).put(piece, [entry.id, entry.pieces - 1]);
      }
      return store(ENTRIES).put(entry);
    });
  }

  /** @param {number} id of a recording that is not wanted any more */
  async remove(id) {
    await this.#do([ENTRIES, PIECES], 'readwrite', (store) => {
      store(PIECES).delete(piecesOf(id));
      return store(ENTRIES).delete(id);
    });
  }

  /** @param {number} id @returns {Promise<Piece[]>} in their order */
  async pieces(id) {
    return (await this.#do([PIECES], 'readonly', (store) => store(PIECES).getAll(piecesOf(id)))) ?? [];
  }

  /**
   * @template T
   * @param {string[]} names
   * @param {IDBTransactionMode} mode
   * @param {(store: (name: string) => IDBObjectStore) => IDBRequest<T>} deed
   * @returns {Promise<T | undefined>}
   */
  async #do(names, mode, deed) {
    const database = await this.#database;
    if (!database) {
      return undefined;
    }
    const transaction = database.transaction(names, mode);
    const request = deed((name) => transaction.objectStore(name));
    transaction.commit();
    return result(request);
  }
}
