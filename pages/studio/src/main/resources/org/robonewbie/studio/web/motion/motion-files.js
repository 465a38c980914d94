/** Client for the motion files of the studio's server. */
import { decodeText, UTF_8 } from '../state/decoded-text.js';
import { decode, encode } from '../state/motion/motion-text.js';
import { pathPart } from '../state/path-part.js';

/**
 * @typedef {import('../state/motion/motion-text.js').MotionDocument} MotionDocument
 *
 * @typedef {object} MotionList
 * @property {string} folder
 * @property {Array<{name: string, version: string}>} own
 * @property {Array<{name: string, version: string}>} drafts
 * @property {string[]} library
 * @property {string[]} leftOut a sentence about each unplayable file of the folder
 */

export class MotionFiles {
  /** @returns {Promise<any>} the robot's description */
  async robot() {
    return (await this.#ask('GET', 'robot')).json();
  }

  /** @returns {Promise<MotionList>} */
  async list() {
    return (await this.#ask('GET', 'motions')).json();
  }

  /**
   * @param {'motions' | 'library' | 'drafts'} collection
   * @param {string} name
   * @returns {Promise<{document: MotionDocument, version: string}>}
   */
  async read(collection, name) {
    const answer = await this.#ask('GET', `${collection}/${pathPart(name)}`);
    const bytes = new Uint8Array(await answer.arrayBuffer());
    try {
      return { document: decode(bytes), version: answer.headers.get('Version') ?? '' };
    } catch (error) {
      const problem = /** @type {Error} */ (error).message;
      throw new Error(`${name}.txt cannot be opened: ${problem} It stays as it is.`, { cause: error });
    }
  }

  /**
   * @param {string} name
   * @param {MotionDocument} document
   * @param {string} known the version last read by this page, empty for a new file
   * @returns {Promise<string>} the new version
   */
  async write(name, document, known) {
    const answer = await this.#ask('PUT', `motions/${pathPart(name)}`, encode(document), {
      'Known-Version': known,
    });
    return answer.headers.get('Version') ?? '';
  }

  /** @param {string} name @param {MotionDocument} document */
  async writeDraft(name, document) {
    await this.#ask('PUT', `drafts/${pathPart(name)}`, encode(document));
  }

  /** @param {string} name */
  async removeDraft(name) {
    await this.#ask('DELETE', `drafts/${pathPart(name)}`);
  }

  /** @returns {Promise<string>} */
  async postures() {
    const answer = await this.#ask('GET', 'poses');
    return decodeText(new Uint8Array(await answer.arrayBuffer())).content;
  }

  /** @param {string} text */
  async writePostures(text) {
    await this.#ask('PUT', 'poses', new TextEncoder().encode(text));
  }

  /**
   * @param {MotionDocument} document
   * @param {string} start standing, back or front
   * @returns {Promise<import('../state/motion/editor-state.js').Trial>}
   */
  async trial(document, start) {
    return (await this.#ask('POST', 'trial', encode({ ...document, ...UTF_8 }), { Start: start })).json();
  }

  /**
   * @param {string} method
   * @param {string} path
   * @param {Uint8Array} [body]
   * @param {Record<string, string>} [headers]
   */
  async #ask(method, path, body, headers = {}) {
    const content = /** @type {BodyInit | undefined} */ (body);
    const answer = await fetch(`api/${path}`, { method, body: content, headers });
    if (!answer.ok) {
      throw Object.assign(new Error(await answer.text()), { status: answer.status });
    }
    return answer;
  }
}
