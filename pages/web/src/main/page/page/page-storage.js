/**
 * Strings in the browser's local storage. All pages of an origin share one storage; each folder uses its own key prefix, so that two
 * editions of RoboNewbie on one host do not share programs.
 */

/** Keys written before each folder had its own prefix. */
const COMMON = /^robonewbie-page-/;
const MIGRATED = 'robonewbie-migrated';

export const NO_ROOM =
  'This browser has no space left for this page: nothing was saved, and the text exists only here. ' +
  'Press Download, or copy the text into a file; then delete scenes that you do not need.';

/** In-memory storage for browsers that deny access to local storage. */
class OpenPage {
  #texts = new Map();

  get length() {
    return this.#texts.size;
  }

  /** @param {number} index */
  key(index) {
    return [...this.#texts.keys()][index] ?? null;
  }

  /** @param {string} key @returns {string | null} */
  getItem(key) {
    return this.#texts.get(key) ?? null;
  }

  /** @param {string} key @param {string} text */
  setItem(key, text) {
    this.#texts.set(key, text);
  }

  /** @param {string} key */
  removeItem(key) {
    this.#texts.delete(key);
  }
}

export class PageStorage {
  #store;

  /**
   * @param {() => Pick<Storage, 'length' | 'key' | 'getItem' | 'setItem' | 'removeItem'>} open opens the storage; may throw
   * @param {string} folder folder of the page, with leading and trailing slash
   */
  constructor(open, folder) {
    this.folder = folder;
    /** Whether the content is lost when the page is closed. */
    this.isLost = false;
    try {
      this.#store = open();
      this.#store.getItem(folder);
    } catch {
      this.#store = new OpenPage();
      this.isLost = true;
    }
    this.#migrate();
  }

  /** @param {string} key @returns {string | null} */
  get(key) {
    return this.#store.getItem(this.folder + key);
  }

  /** @param {string} key @param {string} text @throws {Error} if the storage is full; the previous text is kept */
  set(key, text) {
    try {
      this.#store.setItem(this.folder + key, text);
    } catch (full) {
      throw new Error(NO_ROOM, { cause: full });
    }
  }

  /** @param {string} key */
  remove(key) {
    this.#store.removeItem(this.folder + key);
  }

  /** @param {string} prefix @returns {string[]} all keys with this prefix */
  keys(prefix) {
    return this.#all.filter((key) => key.startsWith(this.folder + prefix)).map((key) => key.slice(this.folder.length));
  }

  get #all() {
    return Array.from({ length: this.#store.length }, (_, index) => this.#store.key(index) ?? '');
  }

  /**
   * Copies the data stored before prefixes were introduced, unless this has already been done. Keeps the original if possible, because
   * another edition may need it.
   */
  #migrate() {
    if (this.get(MIGRATED) !== null) {
      return;
    }
    try {
      for (const key of this.#all.filter((each) => COMMON.test(each) && this.get(each) === null)) {
        this.#take(key);
      }
      this.set(MIGRATED, 'yes');
    } catch {
      // The storage is full; retried on the next visit.
    }
  }

  /** @param {string} key */
  #take(key) {
    const text = this.#store.getItem(key) ?? '';
    try {
      this.set(key, text);
    } catch {
      this.#store.removeItem(key); // not enough space for two copies
      try {
        this.set(key, text);
      } catch (full) {
        this.#store.setItem(key, text);
        throw full;
      }
    }
  }
}

/** @returns {string} the folder of this page */
export const folderOfPage = () => new URL('.', location.href).pathname;

/** @type {PageStorage | undefined} */
let ofPage;

/** @returns {PageStorage} the storage of this page */
export const storage = () => (ofPage ??= new PageStorage(() => localStorage, folderOfPage()));
