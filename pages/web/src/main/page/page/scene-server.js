/**
 * Local replacement for the scene server and the button *Start here*. The program in the worker parses and writes scenes; this browser
 * stores them.
 */
import { BrowserRepository } from './browser-repository.js';
import { requestOf, responseOf } from './page-server.js';

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

  /** Request handlers. */
  get parts() {
    /** @type {import('./page-server.js').Part} */
    const served = (values, _, request) => this.#answer(requestOf(request, values));
    return /** @satisfies {Record<string, import('./page-server.js').Part>} */ ({
      'GET scenes': served,
      'PUT scenes/NAME': served,
      'POST scenes/NAME': served,
      'DELETE scenes/NAME': served,
      'POST start/NAME': ({ NAME, moment }) => this.#start(NAME, moment),
    });
  }

  /**
   * Stores a change from the scene service.
   *
   * @param {string} change name and text of a scene as a JSON object; without text, the scene is removed
   */
  keep(change) {
    const { name, text } = JSON.parse(change);
    if (text === undefined) {
      this.#repository.remove(name);
      return;
    }
    try {
      this.#repository.write(name, text);
    } catch {
      this.#isFull = true;
    }
  }

  /** @param {import('./page-server.js').ServiceRequest} request */
  async #answer(request) {
    const path = request.path.slice(1);
    const needed = [...path, request.parameters.was];
    const scenes = Object.fromEntries(
      this.#repository.list.map(({ path }) => [path, (needed.includes(path) && this.#repository.read(path)) || '']),
    );
    const result = await this.questions.ask('answer', 'scenes', JSON.stringify({ ...request, path, scenes }));
    if (this.#isFull) {
      this.#isFull = false;
      throw new Error(NO_ROOM);
    }
    return responseOf(result);
  }

  /** @param {string} name @param {number} moment */
  async #start(name, moment) {
    const recording = await this.recordings.open(name);
    const bytes = new Int8Array(recording.slice().buffer);
    return responseOf(await this.questions.ask('startFrom', bytes, moment));
  }
}
