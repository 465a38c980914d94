/** Client for the motion files on the studio's server. */
import { answer } from '../live/server.js';
import { ServerFiles } from '../live/server-files.js';
import { decodeText, UTF_8 } from '../state/decoded-text.js';
import { bodyOf } from '../state/motion/body.js';
import { decode, encode, NAO, robotOf } from '../state/motion/motion-text.js';

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

const POSTURES = 'poses';

/** @param {import('../live/server-files.js').ListedFile} file */
const named = ({ path, version }) => ({ name: path, version });

export class MotionFiles {
  /** Robots by name. @type {Map<string, import('../state/motion/body.js').Body>} */
  #bodies = new Map();
  #files = {
    motions: new ServerFiles('motion'),
    drafts: new ServerFiles('motion-draft'),
    library: new ServerFiles('motion-library'),
  };
  #postures = new ServerFiles('postures');

  /** @param {string} [robot] name of a robot @returns {Promise<import('../state/motion/body.js').Body>} */
  async body(robot = NAO) {
    const known = this.#bodies.get(robot);
    if (known) {
      return known;
    }
    const body = bodyOf(await (robot === NAO ? answer('GET robot') : answer('GET robot/NAME', { NAME: robot })));
    this.#bodies.set(robot, body);
    return body;
  }

  /** @returns {Promise<MotionList>} */
  async list() {
    const kinds = [this.#files.motions, this.#files.drafts, this.#files.library];
    const [own, drafts, library] = await Promise.all(kinds.map((files) => files.list()));
    return {
      folder: own.folder,
      own: own.files.map(named),
      drafts: drafts.files.map(named),
      library: library.files.map(({ path }) => path),
      leftOut: own.leftOut,
    };
  }

  /**
   * @param {'motions' | 'library' | 'drafts'} collection
   * @param {string} name
   * @returns {Promise<{document: MotionDocument, version: string, body: import('../state/motion/body.js').Body}>} the motion, and the robot
   *     that it is for
   */
  async read(collection, name) {
    const { bytes, version } = await this.#files[collection].read(name);
    try {
      const document = decode(bytes);
      const body = await this.body(robotOf(document));
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
    return this.#files.motions.write(name, encode(document), known);
  }

  /** @param {string} name @param {MotionDocument} document */
  async writeDraft(name, document) {
    await this.#files.drafts.write(name, encode(document));
  }

  /** @param {string} name */
  async removeDraft(name) {
    await this.#files.drafts.remove(name);
  }

  /** @returns {Promise<string>} */
  async postures() {
    return decodeText((await this.#postures.read(POSTURES)).bytes).content;
  }

  /** @param {string} text */
  async writePostures(text) {
    await this.#postures.write(POSTURES, text);
  }

  /**
   * @param {MotionDocument} document
   * @param {string} start standing, back or front
   * @returns {Promise<import('../state/motion/editor-state.js').Trial>}
   */
  async trial(document, start) {
    const body = encode({ ...document, ...UTF_8 });
    return answer('POST trial', {}, { body, headers: { Start: start } });
  }
}
