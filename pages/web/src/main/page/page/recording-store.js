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
import { folderOfPage, storage } from './page-storage.js';

/** What an edition kept before each folder of a host had its own part. */
const COMMON = 'robonewbie';
const MIGRATED = 'robonewbie-migrated-recordings';

const NO_ROOM = 'This browser has no room for this recording. Delete others in the room Replay, or save them as files.';
const ENTRIES = 'recordings';
const PIECES = 'pieces';

/** @template T @param {IDBRequest<T>} request @returns {Promise<T>} */
const result = (request) =>
  new Promise((done, fail) => {
    request.onsuccess = () => done(request.result);
    request.onerror = () => fail(request.error);
  });

/** @param {IDBTransaction} transaction @returns {Promise<void>} what is written is there only when it has ended */
const ended = (transaction) =>
  new Promise((done, fail) => {
    transaction.oncomplete = () => done();
    transaction.onabort = () => fail(transaction.error ?? new Error('The browser has given up.'));
  });

/** @param {string} name @returns {Promise<IDBDatabase>} */
function openDatabase(name) {
  const request = indexedDB.open(name, 1);
  request.onupgradeneeded = () => {
    request.result.createObjectStore(ENTRIES, { keyPath: 'id' });
    request.result.createObjectStore(PIECES);
  };
  return result(request);
}

/** @returns {Promise<IDBDatabase>} */
async function open() {
  const database = await openDatabase(`${COMMON} ${folderOfPage()}`);
  if (storage().get(MIGRATED) === null) {
    await takeCommon(database).catch(() => {}); // without room, the next visit tries it again
  }
  return database;
}

/** Takes over the recordings of the whole host, once; another edition of the host may want them too. @param {IDBDatabase} database */
async function takeCommon(database) {
  const common = await openDatabase(COMMON);
  const read = (/** @type {string} */ store) => common.transaction(store).objectStore(store);
  for (const entry of await result(read(ENTRIES).getAll())) {
    const pieces = await result(read(PIECES).getAll(piecesOf(entry.id)));
    const into = database.transaction([ENTRIES, PIECES], 'readwrite');
    const end = ended(into);
    pieces.forEach((piece, index) => into.objectStore(PIECES).put(piece, [entry.id, index]));
    into.objectStore(ENTRIES).put(entry);
    await end;
  }
  common.close();
  storage().set(MIGRATED, 'yes');
}

/** The keys of all pieces of a recording. @param {number} id */
const piecesOf = (id) => IDBKeyRange.bound([id, 0], [id, Infinity]);

export class RecordingStore {
  #database = open().catch(() => undefined);
  #isFull = false;
  /** Told once that the browser has no room for recordings. */
  full = (/** @type {string} */ _text) => {};

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
   * @param {(store: (name: string) => IDBObjectStore) => IDBRequest<T>} action
   * @returns {Promise<T | undefined>}
   */
  async #do(names, mode, action) {
    const database = await this.#database;
    if (!database) {
      return undefined;
    }
    const transaction = database.transaction(names, mode);
    const end = ended(transaction);
    const request = action((name) => transaction.objectStore(name));
    transaction.commit();
    try {
      await end;
    } catch (failure) {
      throw this.#inWords(/** @type {Error} */ (failure));
    }
    return request.result;
  }

  /** @param {Error} failure @returns {Error} meant for people, if they can do something about it */
  #inWords(failure) {
    if (failure.name !== 'QuotaExceededError') {
      return failure;
    }
    if (!this.#isFull) {
      this.#isFull = true;
      this.full(NO_ROOM);
    }
    return new Error(NO_ROOM, { cause: failure });
  }
}
