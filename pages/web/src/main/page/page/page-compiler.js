/** Client for the Java compiler worker, which starts when the program room is first opened. */
import { insteadOfMissing, missingClasses } from './missing-classes.js';

/**
 * @typedef {import('../state/program/remarks.js').Remark} Remark
 * @typedef {import('../program/program-service.js').Proposal} Proposal
 * @typedef {{remarks: Remark[], classes: Int8Array[]}} Compiled
 * @typedef {Record<string, Record<string, string>>} Comments documentation by class and member
 */

/** Folders cached for offline use once the user starts programming. */
const FOR_PROGRAMS = ['compiler/', 'programs/', 'vendor/codemirror/'];

export class PageCompiler {
  /** @type {Worker | undefined} */
  #worker;
  #asked = 0;
  /** @type {Promise<Map<string, string>> | undefined} Java classes that this page lacks */
  #missing;
  /** @type {Promise<Comments> | undefined} documentation of RoboNewbie's classes */
  #comments;
  #begun;
  /** @type {Map<number, {done: (made: any) => void, fail: (reason: Error) => void}>} */
  #waiting = new Map();

  /** @param {() => void} begun called when the user starts programming */
  constructor(begun) {
    this.#begun = begun;
  }

  /**
   * @param {Map<string, string>} sources text by path
   * @param {string} shown the path of the file in the editor
   * @returns {Promise<Compiled>}
   */
  async compile(sources, shown) {
    const made = await this.#ask([...sources]);
    this.#missing ??= fetch('compiler/missing.txt').then(async (answer) => missingClasses(await answer.text()));
    const missing = made.remarks.length === 0 ? new Map() : await this.#missing;
    return { remarks: remarks(made.remarks, shown, sources.get(shown) ?? '', missing), classes: made.classes };
  }

  /**
   * @param {Map<string, string>} sources text by path, the file in the editor first
   * @param {number} at index of the cursor
   * @returns {Promise<Proposal[]>}
   */
  async complete(sources, at) {
    this.#comments ??= fetch('compiler/comments.json').then((answer) => answer.json());
    const { proposals } = await this.#ask([...sources], at);
    const comments = await this.#comments;
    return proposals.map((/** @type {string} */ each) => proposal(each, comments));
  }

  /** @param {[string, string][]} sources @param {number} [at] @returns {Promise<any>} */
  #ask(sources, at) {
    this.#worker ??= this.#begin();
    this.#asked += 1;
    const id = this.#asked;
    this.#worker.postMessage({ id, sources, at });
    return new Promise((done, fail) => {
      this.#waiting.set(id, { done, fail });
    });
  }

  #begin() {
    const worker = new Worker('compiler-worker.js', { type: 'module' });
    this.#begun();
    navigator.serviceWorker?.ready.then(({ active }) => active?.postMessage({ keep: FOR_PROGRAMS }));
    worker.onmessage = ({ data }) => {
      const waiting = this.#waiting.get(data.id);
      this.#waiting.delete(data.id);
      if (data.failure) {
        waiting?.fail(new Error(`The compiler on this page has failed: ${data.failure}. Reload the page.`));
      } else {
        waiting?.done(data);
      }
    };
    return worker;
  }
}

/**
 * @param {string[]} lines diagnostics of the compiler, with tab-separated fields
 * @param {string} shown
 * @param {string} text
 * @param {Map<string, string>} missing
 * @returns {Remark[]} the diagnostics; only those of the displayed file have a position
 */
function remarks(lines, shown, text, missing) {
  return lines.map((line) => {
    const [kind, path, number, begin, end, hint, ...words] = line.split('\t');
    const isHere = path === shown && Number(begin) >= 0;
    const from = isHere ? Math.min(Number(begin), text.length) : 0;
    const to = isHere ? Math.max(from, Math.min(Number(end), text.length)) : 0;
    return {
      from,
      to,
      line: isHere ? Number(number) : 0,
      serious: kind === 'ERROR',
      text: (isHere || path === '' ? '' : `${path}:${number}: `) + words.join('\t'),
      hint: insteadOfMissing(words.join('\t'), missing, text.slice(from, to)) || hint,
    };
  });
}

/** @param {string} line proposal of the compiler, with tab-separated fields @param {Comments} comments @returns {Proposal} */
function proposal(line, comments) {
  const [label, detail, kind, insert, own = '', owner = '', key = ''] = line.split('\t');
  const documentation = own || comments[owner.replace(/\$.*/, '')]?.[key] || '';
  return { label, detail, kind, insert, documentation };
}
