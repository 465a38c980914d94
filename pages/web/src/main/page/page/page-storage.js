/**
 * Texts that the browser keeps for this page. All pages of a host share one storage; here each folder of the host has its own part of it,
 * so that two editions of RoboNewbie beside each other do not share programs.
 */

/** What an edition kept before each folder had its own part. */
const COMMON = /^robonewbie-page-/;
const MIGRATED = 'robonewbie-migrated';

export const NO_ROOM =
  'This browser has no room left for this page: nothing was saved, and the text is only here. ' +
  'Press Download, or copy the text into a file; then delete scenes that you do not need.';

/** Keeps texts as long as the page is open, where the browser allows no more. */
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
   * @param {() => Pick<Storage, 'length' | 'key' | 'getItem' | 'setItem' | 'removeItem'>} open a browser may refuse it
   * @param {string} folder of the page, which begins and ends with a slash
   */
  constructor(open, folder) {
    this.folder = folder;
    /** Whether nothing is there any more when the page is opened again. */
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

  /** @param {string} key @param {string} text @throws {Error} if there is no room; what was there before is there still */
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

  /** @param {string} prefix @returns {string[]} all keys that begin with it */
  keys(prefix) {
    return this.#all.filter((key) => key.startsWith(this.folder + prefix)).map((key) => key.slice(this.folder.length));
  }

  get #all() {
    return Array.from({ length: this.#store.length }, (_, index) => this.#store.key(index) ?? '');
  }

  /** Takes over what was kept for the whole host, once; another edition of the host may want it too. */
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
      // There is no room; the next visit tries the rest again.
    }
  }

  /** @param {string} key */
  #take(key) {
    const text = this.#store.getItem(key) ?? '';
    try {
      this.set(key, text);
    } catch {
      this.#store.removeItem(key); // two of them have no room
      try {
        this.set(key, text);
      } catch (full) {
        this.#store.setItem(key, text);
        throw full;
      }
    }
  }
}

/** @returns {string} the folder of the host in which this page is */
export const folderOfPage = () => new URL('.', location.href).pathname;

/** @type {PageStorage | undefined} */
let ofPage;

/** @returns {PageStorage} that of this page */
export const storage = () => (ofPage ??= new PageStorage(() => localStorage, folderOfPage()));
