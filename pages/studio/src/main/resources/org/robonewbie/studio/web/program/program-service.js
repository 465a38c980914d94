/** Client for everything that the program room needs: files, compiler, processes, exercises. The room's only access to the server. */

import { answer, ask } from '../live/server.js';
import { ServerFiles } from '../live/server-files.js';
import { decodeText, legibleText, UTF_8 } from '../state/decoded-text.js';
import { versionsFrom } from '../state/program/versions.js';

/**
 * @typedef {import('../live/server-files.js').ListedFile} ListedFile
 *
 * @typedef {object} ProgramList
 * @property {boolean} open whether programs can be written at all
 * @property {string} folder
 * @property {ListedFile[]} own
 * @property {ListedFile[]} drafts
 * @property {string[]} examples
 * @property {{path: string, example: string}} [first] the program that has been running since the studio was opened; if it is an example,
 *     its copy has not been created yet
 * @property {Array<{path: string, before: string}>} [shared] drafts opened by a link, with the program that was open before
 *
 * @typedef {import('../state/program/remarks.js').Remark} Remark
 * @typedef {import('../state/program/run.js').ProgramRun} ProgramRun
 * @typedef {import('../state/course.js').Lesson} Lesson
 * @typedef {import('../state/course.js').Attempt} Attempt
 * @typedef {import('../state/program/documents.js').ReadProgram} ReadProgram
 * @typedef {import('../state/program/versions.js').Version} Version
 * @typedef {{label: string, detail: string, kind: string, insert: string, documentation: string}} Proposal
 */

export class ProgramService {
  #files = {
    own: new ServerFiles('program'),
    draft: new ServerFiles('program-draft'),
    example: new ServerFiles('example'),
  };
  #histories = new ServerFiles('program-history');

  /** @returns {Promise<ProgramList>} */
  async list() {
    const lists = [this.#files.own, this.#files.draft, this.#files.example].map((files) => files.list());
    const [state, own, drafts, examples] = await Promise.all([answer('GET programs'), ...lists]);
    return {
      ...state,
      folder: own.folder,
      own: own.files,
      drafts: drafts.files,
      examples: examples.files.map(({ path }) => path),
    };
  }

  /** @param {'own' | 'draft' | 'example'} kind @param {string} path @returns {Promise<ReadProgram>} */
  async read(kind, path) {
    const { bytes, version } = await this.#files[kind].read(path);
    try {
      return { text: decodeText(bytes), version, problem: '' };
    } catch (error) {
      const problem = /** @type {Error} */ (error).message;
      return { text: { ...UTF_8, content: legibleText(bytes) }, version, problem };
    }
  }

  /** @param {string} path @param {string} [example] template @returns {Promise<string>} the text of a new program */
  async newProgram(path, example = '') {
    return (await ask('GET programs/new/PATH', { PATH: path, example })).text();
  }

  /**
   * @param {string} path
   * @param {Uint8Array} bytes
   * @param {string} known the version last read by this page, empty for a new file
   * @returns {Promise<string>} the new version
   */
  async write(path, bytes, known) {
    return this.#files.own.write(path, bytes, known);
  }

  /**
   * @param {string} path
   * @param {string} text
   * @param {string} known version of the draft to replace
   * @returns {Promise<string>} the new version
   */
  async writeDraft(path, text, known) {
    return this.#files.draft.write(path, text, known);
  }

  /** @param {string} path @param {string} known version to remove; any other is kept */
  async removeDraft(path, known) {
    await this.#files.draft.remove(path, known);
  }

  /** @param {string} path @returns {Promise<Version[]>} its saved versions, oldest first */
  async history(path) {
    const { bytes } = await this.#histories.read(path);
    return versionsFrom(JSON.parse(decodeText(bytes).content || '[]'));
  }

  /** @param {string} path @param {Version[]} versions */
  async writeHistory(path, versions) {
    await this.#histories.write(path, JSON.stringify(versions));
  }

  /** @param {string} path @param {string} text @returns {Promise<Remark[]>} */
  async check(path, text) {
    return answer('POST programs/check/PATH', { PATH: path }, { body: text });
  }

  /** @param {string} path @param {string} text @param {number} at @returns {Promise<Proposal[]>} */
  async complete(path, text, at) {
    return answer('POST programs/complete/PATH', { PATH: path, at }, { body: text });
  }

  /** @param {string} path @param {'keep' | 'fresh'} world @returns {Promise<ProgramRun>} */
  async run(path, world) {
    return answer('POST programs/run/PATH', { PATH: path, world });
  }

  /** @returns {Promise<ProgramRun>} */
  async state() {
    return answer('GET programs/run');
  }

  /** @returns {Promise<ProgramRun>} */
  async stop() {
    return answer('DELETE programs/run');
  }

  /** @returns {Promise<Lesson[]>} */
  async lessons() {
    return (await answer('GET course')).lessons;
  }

  /** Creates the starter program of an exercise. @param {string} lesson @returns {Promise<string>} its path */
  async createStarter(lesson) {
    return answer('PUT course/NAME', { NAME: lesson });
  }

  /** @param {string} lesson @param {string} path @param {number} trials @returns {Promise<Attempt>} */
  async attempt(lesson, path, trials) {
    return answer('POST course/NAME', { NAME: lesson, program: path, trials });
  }

  /** @returns {Promise<Attempt>} */
  async attemptNow() {
    return answer('GET course/attempt');
  }

  /** @returns {Promise<Attempt>} */
  async leaveAttempt() {
    return answer('DELETE course/attempt');
  }
}
