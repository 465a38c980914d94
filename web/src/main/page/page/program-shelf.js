/** The programs of the person, kept by the browser: closed and opened again, the page has them all. */

const FILE = 'robonewbie-page-file:';
const LAST = 'robonewbie-program';
const DRAFT = 'robonewbie-page-draft:';

/** @param {string} text @returns {string} another one for another text */
export function versionOf(text) {
  let hash = 5381;
  for (let i = 0; i < text.length; i += 1) {
    hash = (Math.imul(hash, 33) + text.charCodeAt(i)) | 0;
  }
  return `${text.length}.${hash >>> 0}`;
}

/** @param {string} prefix @returns {{path: string, version: string}[]} */
function listed(prefix) {
  return Object.keys(localStorage)
    .filter((key) => key.startsWith(prefix))
    .map((key) => ({ path: key.slice(prefix.length), version: versionOf(localStorage.getItem(key) ?? '') }))
    .sort((one, other) => one.path.localeCompare(other.path));
}

export class ProgramShelf {
  get own() {
    return listed(FILE);
  }

  get drafts() {
    return listed(DRAFT);
  }

  /** @returns {Map<string, string>} the texts of all saved files */
  get texts() {
    return new Map(this.own.map(({ path }) => [path, localStorage.getItem(FILE + path) ?? '']));
  }

  /** @param {'own' | 'draft'} shelf @param {string} path @returns {string | null} */
  read(shelf, path) {
    return localStorage.getItem((shelf === 'own' ? FILE : DRAFT) + path);
  }

  /** @param {string} path @param {string} text */
  write(path, text) {
    localStorage.setItem(FILE + path, text);
    this.removeDraft(path);
  }

  /** @param {string} path @param {string} text */
  writeDraft(path, text) {
    localStorage.setItem(DRAFT + path, text);
  }

  /** Puts a program that came with the address beside what is there, and opens it first. @param {string} path @param {string} text */
  takeShared(path, text) {
    this.writeDraft(path, text);
    localStorage.setItem(LAST, JSON.stringify(path));
  }

  /** @param {string} path */
  removeDraft(path) {
    localStorage.removeItem(DRAFT + path);
  }
}
