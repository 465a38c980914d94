/** Texts with names, kept by the browser: closed and opened again, the page has them all. */
import { storage } from './page-storage.js';

const CHUNK = 8192;

/** Some things are bytes, and the browser's memory takes texts: a character for each byte. @param {Uint8Array} bytes */
export function asText(bytes) {
  let text = '';
  for (let i = 0; i < bytes.length; i += CHUNK) {
    text += String.fromCharCode(...bytes.subarray(i, i + CHUNK));
  }
  return text;
}

/** @param {string} text @returns {Uint8Array<ArrayBuffer>} */
export const asBytes = (text) => Uint8Array.from(text, (letter) => letter.charCodeAt(0));

/** @param {string} text @returns {string} another one for another text */
export function versionOf(text) {
  let hash = 5381;
  for (let i = 0; i < text.length; i += 1) {
    hash = (Math.imul(hash, 33) + text.charCodeAt(i)) | 0;
  }
  return `${text.length}.${hash >>> 0}`;
}

export class BrowserRepository {
  /** @param {string} prefix of the shelf's keys in the page's storage @param {() => import('./page-storage.js').PageStorage} [open] */
  constructor(prefix, open = storage) {
    this.prefix = prefix;
    this.open = open;
  }

  /** @returns {{path: string, version: string}[]} */
  get list() {
    return this.open()
      .keys(this.prefix)
      .map((key) => ({ path: key.slice(this.prefix.length), version: versionOf(this.open().get(key) ?? '') }))
      .sort((one, other) => one.path.localeCompare(other.path));
  }

  /** @param {string} path @returns {string | null} */
  read(path) {
    return this.open().get(this.prefix + path);
  }

  /** @param {string} path @param {string} text */
  write(path, text) {
    this.open().set(this.prefix + path, text);
  }

  /**
   * Writes a text that nothing may replace: if another one of this name is there, nothing happens.
   *
   * @param {string} path
   * @param {string} text
   * @returns {boolean} whether it is there now
   */
  add(path, text) {
    const there = this.read(path);
    if (there === null) {
      this.write(path, text);
    }
    return there === null || there === text;
  }

  /**
   * Writes a text unless another one is there than the writer knows.
   *
   * @param {string} path
   * @param {string} text
   * @param {string} known version of what the writer has read
   * @returns {Response} with the new version, or a refusal
   */
  overwrite(path, text, known) {
    const there = this.read(path);
    if (there !== null && there !== text && versionOf(there) !== known) {
      const refusal = `${path} was changed in another window. Load it again, or save under another name.`;
      return new Response(refusal, { status: 409 });
    }
    this.write(path, text);
    return new Response('', { headers: { Version: versionOf(text) } });
  }

  /** @param {string} path @param {string} [known] only this version is removed */
  remove(path, known) {
    if (known !== undefined && versionOf(this.read(path) ?? '') !== known) {
      return;
    }
    this.open().remove(this.prefix + path);
  }
}
