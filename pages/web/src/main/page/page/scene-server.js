/**
 * Local replacement for the scene server and the button *Start here*. The program in the worker reads and writes scenes; this browser
 * stores them.
 */
import { asBytes, asText, BrowserRepository } from './browser-repository.js';

const NO_ROOM = 'This browser has no space left for another scene. Delete one first.';

export class SceneServer {
  #repository = new BrowserRepository('robonewbie-page-scene:');
  #isFull = false;

  /**
   * @param {import('./world-questions.js').WorldQuestions} questions
   * @param {import('./page-recordings.js').PageRecordings} recordings
   */
  constructor(questions, recordings) {
    this.questions = questions;
    this.recordings = recordings;
  }

  /** Request handlers by the first segment of their path. */
  get parts() {
    return {
      scenes: {
        answer: (/** @type {string} */ place, /** @type {RequestInit} */ options) => this.#answer(place, options),
      },
      start: { answer: (/** @type {string} */ place) => this.#start(place) },
    };
  }

  /**
   * Stores a scene written by the program.
   *
   * @param {{name: string, bytes?: Int8Array}} scene scene to store; without bytes it is removed
   */
  keep({ name, bytes }) {
    if (!bytes) {
      this.#repository.remove(name);
      return;
    }
    try {
      this.#repository.write(name, asText(new Uint8Array(bytes)));
    } catch {
      this.#isFull = true;
    }
  }

  /** @param {string} place @param {RequestInit} options */
  async #answer(place, { method = 'GET' }) {
    const [path, search] = place.split('?');
    const old = new URLSearchParams(search).get('was') ?? '';
    this.questions.world.postMessage({ scenes: this.#own });
    const result = await this.questions.ask('scenes', method, decodeURIComponent(path.slice(1)), old);
    if (this.#isFull) {
      this.#isFull = false;
      throw new Error(NO_ROOM);
    }
    return answer(result);
  }

  /** @param {string} place */
  async #start(place) {
    const [path, search] = place.split('?');
    const recording = await this.recordings.open(path.split('/').slice(1).map(decodeURIComponent).join('/'));
    const moment = Number(new URLSearchParams(search).get('moment'));
    return answer(await this.questions.ask('startFrom', new Int8Array(recording.slice().buffer), moment));
  }

  /** @returns {[string, Int8Array][]} name and bytes of each scene */
  get #own() {
    return this.#repository.list.map(({ path }) => [path, new Int8Array(asBytes(this.#repository.read(path) ?? '').buffer)]);
  }
}

/** @param {string} result a JSON object, or an error message */
const answer = (result) => new Response(result, { status: result.startsWith('{') ? 200 : 409 });
