/** Named texts in the browser's storage; they persist when the page is closed. */
import { storage } from './page-storage.js';

const CHUNK = 8192;

/** Encodes bytes as one character per byte, because the browser's storage holds texts. @param {Uint8Array} bytes */
export function asText(bytes) {
  let text = '';
  for (let i = 0; i < bytes.length; i += CHUNK) {
    text += String.fromCharCode(...bytes.subarray(i, i + CHUNK));
  }
  return text;
}

/** @param {string} text @returns {Uint8Array<ArrayBuffer>} */
export const asBytes = (text) => Uint8Array.from(text, (letter) => letter.charCodeAt(0));

/** @param {{body?: BodyInit | null}} message request or answer @returns {Promise<Uint8Array<ArrayBuffer>>} its content */
export const bytesOf = async ({ body }) => new Uint8Array(await new Response(body).arrayBuffer());

/** @param {string} text @returns {string} hash of the text */
export function versionOf(text) {
  let hash = 5381;
  for (let i = 0; i < text.length; i += 1) {
    hash = (Math.imul(hash, 33) + text.charCodeAt(i)) | 0;
  }
  return `${text.length}.${hash >>> 0}`;
}

export class BrowserRepository {
  /** @param {string} prefix prefix of the keys in the page's storage @param {() => import('./page-storage.js').PageStorage} [open] */
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
   * Writes a text unless one with this name exists.
   *
   * @param {string} path
   * @param {string} text
   * @returns {boolean} whether it was written or an equal text exists
   */
  add(path, text) {
    const there = this.read(path);
    if (there === null) {
      this.write(path, text);
    }
    return there === null || there === text;
  }

  /**
   * Writes a text if the stored version is the one that the writer has read.
   *
   * @param {string} path
   * @param {string} text
   * @param {string | null} known version read by the writer; null to replace any
   * @returns {Response} the new version, or a refusal
   */
  overwrite(path, text, known) {
    const there = this.read(path);
    if (known !== null && there !== null && there !== text && versionOf(there) !== known) {
      const refusal = `${path} was changed in another window. Reload it, or save it under another name.`;
      return new Response(refusal, { status: 409 });
    }
    this.write(path, text);
    return new Response('', { headers: { Version: versionOf(text) } });
  }

  /** @param {string} path @param {string | null} [known] version to remove; any other is kept */
  remove(path, known = null) {
    if (known !== null && versionOf(this.read(path) ?? '') !== known) {
      return;
    }
    this.open().remove(this.prefix + path);
  }
}
