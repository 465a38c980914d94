/**
 * Local replacement for the recording server: forwards requests to the replay service in the world's worker, and loads bytes from this
 * browser's storage.
 */
import { requestOf, responseOf } from './page-server.js';
import { simSparkLog } from './recording-log.js';

export class ReplayServer {
  /** @param {import('./page-recordings.js').PageRecordings} recordings @param {import('./world-questions.js').WorldQuestions} questions */
  constructor(recordings, questions) {
    this.recordings = recordings;
    this.questions = questions;
  }

  /** Request handlers by the first segment of their path. */
  get parts() {
    const { recordings } = this;
    return {
      ...Object.fromEntries(
        ['recordings', 'cards', 'index', 'stars', 'bookmarks'].map((kind) => [kind, this.#served(kind)]),
      ),
      pieces: content(async (name, skip) => (await recordings.open(name)).slice(skip)),
      log: content(async (name) => simSparkLog(await recordings.file(name))),
      notes: content(async (name, skip) => new TextEncoder().encode((await recordings.open(name)).notes).slice(skip)),
      models: { answer: async () => responseOf(await this.questions.ask('models')) },
    };
  }

  /** @param {string} kind @returns {import('./page-server.js').Part} */
  #served(kind) {
    return {
      answer: async (place, options) => responseOf(await this.recordings.answer(requestOf(kind + place, options))),
    };
  }
}

/** @param {(name: string, skip: number) => Promise<BodyInit>} load @returns {import('./page-server.js').Part} */
const content = (load) => ({
  answer: async (place, options) => {
    const { path, parameters } = requestOf(place, options);
    return new Response(await load(path.join('/'), Number(parameters.skip ?? 0)));
  },
});
