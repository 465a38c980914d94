/** Worker that runs exercises without a display: it reads and writes submissions, and grades programs. */

/** @typedef {{seed: number, passed: boolean, points: number, finding: string, hint: string}} Judged */

const LOOK = { method: 'GET', path: ['attempt'] };
/** Time without a report after which the grading of a program is abandoned; the worker normally reports several times per second. */
const PATIENCE_MILLISECONDS = 60_000;

export class ClassWorker {
  #worker = this.#begin();
  #asked = 0;
  /** @type {Map<number, (result: string) => void>} */
  #waiting = new Map();
  /** @type {(reason: Error) => void} */
  #fail = () => {};
  #look = () => {};

  #begin() {
    const worker = new Worker('world-worker.js', { type: 'module', name: 'programs' });
    worker.onmessage = ({ data }) => this.#receive(data);
    worker.onerror = ({ message }) => this.#fail(new Error(message));
    return worker;
  }

  /** @param {any} data status message from the worker; text and bytes about the world are ignored */
  #receive(data) {
    if (typeof data === 'string') {
      return;
    }
    if ('result' in data) {
      this.#waiting.get(data.id)?.(data.result);
      this.#waiting.delete(data.id);
    } else if ('failure' in data) {
      this.#fail(new Error(data.failure));
    } else if ('run' in data) {
      this.#look();
    }
  }

  /** @param {string} action action of the worker @param {object} data @returns {Promise<any>} its result */
  async #ask(action, data) {
    this.#asked += 1;
    const id = this.#asked;
    this.#worker.postMessage({ [action]: { id, ...data } });
    const answer = await new Promise((done) => {
      this.#waiting.set(id, done);
    });
    if (!answer.startsWith('{')) {
      throw new Error(answer);
    }
    return JSON.parse(answer);
  }

  /**
   * @param {'submission' | 'programs' | 'table'} action
   * @param {object} request
   * @returns {Promise<any>}
   * @throws {Error} if the request is rejected; the message is meant for the user
   */
  call(action, request) {
    return this.#ask('call', { name: 'classroom', args: [action, JSON.stringify(request)] });
  }

  /**
   * Runs a program in all trials of an exercise.
   *
   * @param {string} exercise
   * @param {number} seeds number of trials
   * @param {Int8Array[]} classes classes of the program
   * @param {[string, Int8Array][]} motions the author's motions by name
   * @returns {Promise<Judged[]>}
   * @throws {Error} if the program cannot be graded
   */
  async judge(exercise, seeds, classes, motions) {
    const start = { method: 'POST', path: [exercise], parameters: { program: exercise, trials: String(seeds) } };
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    let silence;
    try {
      return await new Promise((done, fail) => {
        const follow = (/** @type {{state: string, judged: Judged[]}} */ { state, judged }) =>
          state === 'OVER' && done(judged);
        this.#fail = fail;
        this.#look = () => {
          clearTimeout(silence);
          silence = setTimeout(() => fail(new Error('The program took too long.')), PATIENCE_MILLISECONDS);
          this.#ask('call', { name: 'answer', args: ['course', request(LOOK)] }).then(follow, fail);
        };
        this.#worker.postMessage({ motions });
        this.#ask('exercise', { request: request(start), classes }).then(follow, fail);
        this.#worker.postMessage({ ask: { do: 'speed', factor: 'fastest' } });
      });
    } finally {
      clearTimeout(silence);
      this.#look = () => {};
    }
  }

  /** Terminates the worker; any grading in progress fails. */
  close() {
    this.#worker.terminate();
    this.#fail(new Error('Stopped.'));
  }
}

/** @param {object} wish @returns {string} a request to the course service, without any data stored by the browser */
const request = (wish) =>
  JSON.stringify({ parameters: {}, language: 'en', progress: {}, programs: [], drafts: [], solutions: {}, ...wish });
