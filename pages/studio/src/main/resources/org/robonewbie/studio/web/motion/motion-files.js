/** Client for the motion files on the studio's server. */
import { ask } from '../live/server.js';
import { decodeText, UTF_8 } from '../state/decoded-text.js';
import { bodyOf } from '../state/motion/body.js';
import { decode, encode, NAO, robotOf } from '../state/motion/motion-text.js';
import { pathPart } from '../state/path-part.js';

/**
 * @typedef {import('../state/motion/motion-text.js').MotionDocument} MotionDocument
 *
 * @typedef {object} MotionList
 * @property {string} folder
 * @property {Array<{name: string, version: string}>} own
 * @property {Array<{name: string, version: string}>} drafts
 * @property {string[]} library
 * @property {string[]} leftOut a sentence about each unplayable file in the folder
 */

export class MotionFiles {
  /** Robots by name. @type {Map<string, import('../state/motion/body.js').Body>} */
  #bodies = new Map();

  /** @param {string} [robot] name of a robot @returns {Promise<import('../state/motion/body.js').Body>} */
  async body(robot = NAO) {
    const known = this.#bodies.get(robot);
    if (known) {
      return known;
    }
    const body = bodyOf(await (await ask(robot === NAO ? 'robot' : `robot/${pathPart(robot)}`)).json());
    this.#bodies.set(robot, body);
    return body;
  }

  /** @returns {Promise<MotionList>} */
  async list() {
    return (await ask('motions')).json();
  }

  /**
   * @param {'motions' | 'library' | 'drafts'} collection
   * @param {string} name
   * @returns {Promise<{document: MotionDocument, version: string, body: import('../state/motion/body.js').Body}>} the motion, and the robot
   *     that it is for
   */
  async read(collection, name) {
    const answer = await ask(`${collection}/${pathPart(name)}`);
    const bytes = new Uint8Array(await answer.arrayBuffer());
    try {
      const document = decode(bytes);
      const body = await this.body(robotOf(document));
      const version = answer.headers.get('Version') ?? '';
      return { document: body.isNao ? document : decode(bytes, body.joints.length), version, body };
    } catch (error) {
      const problem = /** @type {Error} */ (error).message;
      throw new Error(`${name}.txt cannot be opened: ${problem} The file was not changed.`, { cause: error });
    }
  }

  /**
   * @param {string} name
   * @param {MotionDocument} document
   * @param {string} known the version last read by this page, empty for a new file
   * @returns {Promise<string>} the new version
   */
  async write(name, document, known) {
    const answer = await ask(`motions/${pathPart(name)}`, {
      method: 'PUT',
      body: encode(document),
      headers: { 'Known-Version': known },
    });
    return answer.headers.get('Version') ?? '';
  }

  /** @param {string} name @param {MotionDocument} document */
  async writeDraft(name, document) {
    await ask(`drafts/${pathPart(name)}`, { method: 'PUT', body: encode(document) });
  }

  /** @param {string} name */
  async removeDraft(name) {
    await ask(`drafts/${pathPart(name)}`, { method: 'DELETE' });
  }

  /** @returns {Promise<string>} */
  async postures() {
    const answer = await ask('poses');
    return decodeText(new Uint8Array(await answer.arrayBuffer())).content;
  }

  /** @param {string} text */
  async writePostures(text) {
    await ask('poses', { method: 'PUT', body: text });
  }

  /**
   * @param {MotionDocument} document
   * @param {string} start standing, back or front
   * @returns {Promise<import('../state/motion/editor-state.js').Trial>}
   */
  async trial(document, start) {
    const body = encode({ ...document, ...UTF_8 });
    return (await ask('trial', { method: 'POST', body, headers: { Start: start } })).json();
  }
}
