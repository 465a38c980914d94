/**
 * Persistent store of recordings in the browser's IndexedDB. It stays empty if the browser does not store data, for example in a private
 * window.
 *
 * @typedef {object} Entry metadata of a recording
 * @property {number} id start time in milliseconds; unique
 * @property {string} name
 * @property {string} agent
 * @property {boolean} starred
 * @property {import('../replay/recording-api.js').Bookmark[]} bookmarks
 * @property {number} bytes total number of bytes
 * @property {number} pieces number of pieces
 * @property {number} removedAt time of deletion in milliseconds; 0 if it is not deleted
 *
 * @typedef {object} Piece the next part of a recording
 * @property {Uint8Array} bytes
 * @property {boolean} isPacked whether the bytes are gzip-compressed
 * @property {string} notes the robots' logs and drawings from this part
 */
import { ended, openDatabase, result } from './database.js';
import { folderOfPage, storage } from './page-storage.js';

/** Name of the database that was in use before each folder had its own. */
const COMMON = 'robonewbie';
const MIGRATED = 'robonewbie-migrated-recordings';

const NO_ROOM =
  'This browser has no space left for this recording. Delete others in the Replay room, or save them as files.';
const ENTRIES = 'recordings';
const PIECES = 'pieces';

/** @param {string} name */
const openRecordings = (name) =>
  openDatabase(name, (database) => {
    database.createObjectStore(ENTRIES, { keyPath: 'id' });
    database.createObjectStore(PIECES);
  });

/** @returns {Promise<IDBDatabase>} */
async function open() {
  const database = await openRecordings(`${COMMON} ${folderOfPage()}`);
  if (storage().get(MIGRATED) === null) {
    await migrateCommon(database).catch(() => {}); // if the storage is full, this is retried on the next visit
  }
  return database;
}

/**
 * Copies the recordings from the database that all editions on the host used to share. The originals are kept, because another edition may
 * need them too.
 *
 * @param {IDBDatabase} database
 */
async function migrateCommon(database) {
  const common = await openRecordings(COMMON);
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

/** Key range of all pieces of a recording. @param {number} id */
const piecesOf = (id) => IDBKeyRange.bound([id, 0], [id, Infinity]);

export class RecordingStore {
  #database = open().catch(() => undefined);
  #isFull = false;
  /** Called once when the browser has no space left for recordings. */
  full = (/** @type {string} */ _text) => {};

  /** @returns {Promise<Entry[]>} */
  async entries() {
    return (await this.#do([ENTRIES], 'readonly', (store) => store(ENTRIES).getAll())) ?? [];
  }

  /** @param {Entry} entry @param {Piece} [piece] last piece of the recording */
  async put(entry, piece) {
    await this.#do([ENTRIES, PIECES], 'readwrite', (store) => {
      if (piece) {
        store(PIECES).put(piece, [entry.id, entry.pieces - 1]);
      }
      return store(ENTRIES).put(entry);
    });
  }

  /** @param {number} id id of the recording to remove */
  async remove(id) {
    await this.#do([ENTRIES, PIECES], 'readwrite', (store) => {
      store(PIECES).delete(piecesOf(id));
      return store(ENTRIES).delete(id);
    });
  }

  /** @param {number} id @returns {Promise<Piece[]>} the pieces in order */
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
      throw this.#explained(/** @type {Error} */ (failure));
    }
    return request.result;
  }

  /** @param {Error} failure @returns {Error} the failure, with a message for the user if there is a remedy */
  #explained(failure) {
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
