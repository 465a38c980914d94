/** Client for everything that the program room needs: files, compiler, processes, exercises. The room's only access to the server. */

import { ask } from '../live/server.js';
import { decodeText, legibleText, UTF_8 } from '../state/decoded-text.js';
import { versionsFrom } from '../state/program/versions.js';

/**
 * @typedef {{path: string, version: string}} ListedFile
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
  /** @returns {Promise<ProgramList>} */
  async list() {
    return (await ask('programs')).json();
  }

  /** @param {'own' | 'draft' | 'example'} kind @param {string} path @returns {Promise<ReadProgram>} */
  async read(kind, path) {
    const answer = await ask(`programs/${kind}/${escaped(path)}`);
    const version = answer.headers.get('Version') ?? '';
    const bytes = new Uint8Array(await answer.arrayBuffer());
    try {
      return { text: decodeText(bytes), version, problem: '' };
    } catch (error) {
      const problem = /** @type {Error} */ (error).message;
      return { text: { ...UTF_8, content: legibleText(bytes) }, version, problem };
    }
  }

  /** @param {string} path @param {string} [example] template @returns {Promise<string>} the text of a new program */
  async newProgram(path, example = '') {
    const how = new URLSearchParams({ example });
    return (await ask(`programs/new/${escaped(path)}?${how}`)).text();
  }

  /**
   * @param {string} path
   * @param {Uint8Array} bytes
   * @param {string} known the version last read by this page, empty for a new file
   * @returns {Promise<string>} the new version
   */
  async write(path, bytes, known) {
    const content = /** @type {BodyInit} */ (bytes);
    const answer = await ask(`programs/own/${escaped(path)}`, {
      method: 'PUT',
      body: content,
      headers: { 'Known-Version': known },
    });
    return answer.headers.get('Version') ?? '';
  }

  /**
   * @param {string} path
   * @param {string} text
   * @param {string} known version of the draft to replace
   * @returns {Promise<string>} the new version
   */
  async writeDraft(path, text, known) {
    const answer = await ask(`programs/draft/${escaped(path)}`, {
      method: 'PUT',
      body: text,
      headers: { 'Known-Version': known },
    });
    return answer.headers.get('Version') ?? '';
  }

  /** @param {string} path @param {string} known version to remove; any other is kept */
  async removeDraft(path, known) {
    await ask(`programs/draft/${escaped(path)}`, { method: 'DELETE', headers: { 'Known-Version': known } });
  }

  /** @param {string} path @returns {Promise<Version[]>} its saved versions, oldest first */
  async history(path) {
    return versionsFrom(await (await ask(`programs/history/${escaped(path)}`)).json());
  }

  /** @param {string} path @param {Version[]} versions */
  async writeHistory(path, versions) {
    await ask(`programs/history/${escaped(path)}`, { method: 'PUT', body: JSON.stringify(versions) });
  }

  /** @param {string} path @param {string} text @returns {Promise<Remark[]>} */
  async check(path, text) {
    return (await ask(`programs/check/${escaped(path)}`, { method: 'POST', body: text })).json();
  }

  /** @param {string} path @param {string} text @param {number} at @returns {Promise<Proposal[]>} */
  async complete(path, text, at) {
    return (await ask(`programs/complete/${escaped(path)}?at=${at}`, { method: 'POST', body: text })).json();
  }

  /** @param {string} path @param {'keep' | 'fresh'} world @returns {Promise<ProgramRun>} */
  async run(path, world) {
    return (await ask(`programs/run/${escaped(path)}?world=${world}`, { method: 'POST' })).json();
  }

  /** @returns {Promise<ProgramRun>} */
  async state() {
    return (await ask('programs/run')).json();
  }

  /** @returns {Promise<ProgramRun>} */
  async stop() {
    return (await ask('programs/run', { method: 'DELETE' })).json();
  }

  /** @returns {Promise<Lesson[]>} */
  async lessons() {
    return (await (await ask('course')).json()).lessons;
  }

  /** Creates the starter program of an exercise. @param {string} lesson @returns {Promise<string>} its path */
  async createStarter(lesson) {
    return (await ask(`course/${lesson}`, { method: 'PUT' })).json();
  }

  /** @param {string} lesson @param {string} path @param {number} trials @returns {Promise<Attempt>} */
  async attempt(lesson, path, trials) {
    const how = new URLSearchParams({ program: path, trials: String(trials) });
    return (await ask(`course/${lesson}?${how}`, { method: 'POST' })).json();
  }

  /** @returns {Promise<Attempt>} */
  async attemptNow() {
    return (await ask('course/attempt')).json();
  }

  /** @returns {Promise<Attempt>} */
  async leaveAttempt() {
    return (await ask('course/attempt', { method: 'DELETE' })).json();
  }
}

/** @param {string} path */
function escaped(path) {
  return path.split('/').map(encodeURIComponent).join('/');
}
