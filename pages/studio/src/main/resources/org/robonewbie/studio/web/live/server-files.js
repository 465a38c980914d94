/** Client for files of one kind on the studio's server. */
import { answer, ask } from './server.js';

/**
 * @typedef {{path: string, version: string}} ListedFile
 * @typedef {object} FileList
 * @property {string} folder
 * @property {ListedFile[]} files
 * @property {string[]} leftOut a sentence about each file that cannot be used
 */

export class ServerFiles {
  /** @param {string} kind such as `program` or `motion-draft` */
  constructor(kind) {
    this.kind = kind;
  }

  /** @returns {Promise<FileList>} */
  async list() {
    return answer('GET files/KIND', { KIND: this.kind });
  }

  /** @param {string} path @returns {Promise<{bytes: Uint8Array<ArrayBuffer>, version: string}>} */
  async read(path) {
    const response = await ask('GET files/KIND/PATH', this.#place(path));
    return { bytes: new Uint8Array(await response.arrayBuffer()), version: response.headers.get('Version') ?? '' };
  }

  /**
   * @param {string} path
   * @param {string | Uint8Array} content
   * @param {string} [known] the version last read by this page, empty for a new file; omitted to replace any version of a draft
   * @returns {Promise<string>} the new version
   */
  async write(path, content, known) {
    const body = /** @type {BodyInit} */ (content);
    const response = await ask('PUT files/KIND/PATH', this.#place(path), { body, headers: head(known) });
    return response.headers.get('Version') ?? '';
  }

  /** @param {string} path @param {string} [known] version to remove; any other is kept */
  async remove(path, known) {
    await ask('DELETE files/KIND/PATH', this.#place(path), { headers: head(known) });
  }

  /** @param {string} path */
  #place(path) {
    return { KIND: this.kind, PATH: path };
  }
}

/** @param {string | undefined} known @returns {Record<string, string>} */
const head = (known) => (known === undefined ? {} : { 'Known-Version': known });
