/** Java's compiler in a worker of its own, which begins when somebody opens the room for programs. */
import { insteadOfMissing } from './missing-classes.js';

/**
 * @typedef {import('../state/program/remarks.js').Remark} Remark
 * @typedef {{remarks: Remark[], classes: Int8Array[]}} Compiled
 */

/** What is kept for times without a network as soon as somebody has programmed. */
const FOR_PROGRAMS = ['compiler/', 'programs/', 'examples/', 'vendor/codemirror/'];

export class PageCompiler {
  /** @type {Worker | undefined} */
  #worker;
  #asked = 0;
  #begun;
  /** @type {Map<number, {done: (made: any) => void, fail: (reason: Error) => void}>} */
  #waiting = new Map();

  /** @param {() => void} begun what else is loaded when somebody programs */
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
    return { remarks: remarks(made.remarks, shown, sources.get(shown) ?? ''), classes: made.classes };
  }

  /** @param {[string, string][]} sources @returns {Promise<{remarks: string[], classes: Int8Array[]}>} */
  #ask(sources) {
    this.#worker ??= this.#begin();
    this.#asked += 1;
    const id = this.#asked;
    this.#worker.postMessage({ id, sources });
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
        waiting?.fail(new Error(`The compiler of this page has failed: ${data.failure}. Load the page again.`));
      } else {
        waiting?.done(data);
      }
    };
    return worker;
  }
}

/**
 * @param {string[]} lines one remark of the compiler each, with tabs between its parts
 * @param {string} shown
 * @param {string} text
 * @returns {Remark[]} those of the file in the editor, and those of no place
 */
function remarks(lines, shown, text) {
  return lines.map((line) => {
    const [kind, path, number, , begin, end, , ...words] = line.split('\t');
    const isHere = path === shown && Number(begin) >= 0;
    const from = isHere ? Math.min(Number(begin), text.length) : 0;
    return {
      from,
      to: isHere ? Math.max(from, Math.min(Number(end), text.length)) : 0,
      line: isHere ? Number(number) : 0,
      serious: kind === 'ERROR',
      text: (isHere || path === '' ? '' : `${path}:${number}: `) + words.join('\t'),
      hint: insteadOfMissing(words.join('\t')),
    };
  });
}
