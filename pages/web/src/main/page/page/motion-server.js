/** Local replacement for the motion server: the user's motions, those of the library, and trials on a robot with full physics. */
import { decodeText } from '../state/decoded-text.js';
import { composedName, nameProblem } from '../state/file-name.js';
import { asBytes, asText, BrowserRepository, versionOf } from './browser-repository.js';

const POSES = 'poses';

/** @param {RequestInit} options */
const bodyOf = async (options) => new Uint8Array(await new Response(options.body).arrayBuffer());

/** @param {BrowserRepository} repository */
const entries = (repository) => repository.list.map(({ path, version }) => ({ name: path, version }));

export class MotionServer {
  #own = new BrowserRepository('robonewbie-page-motion:');
  #drafts = new BrowserRepository('robonewbie-page-motion-draft:');
  #poses = new BrowserRepository('robonewbie-page-postures:');
  /** Called after one of the user's motions has been saved or removed. */
  changed = () => {};

  /** @param {import('./world-questions.js').WorldQuestions} questions */
  constructor(questions) {
    this.questions = questions;
  }

  /** @returns {[string, Int8Array][]} name and bytes of each motion of the user */
  get own() {
    return this.#own.list.map(({ path }) => [path, new Int8Array(asBytes(this.#own.read(path) ?? '').buffer)]);
  }

  /** Request handlers by the first segment of their path. */
  get parts() {
    return {
      robot: { answer: (/** @type {string} */ place) => this.#describe(decodeURIComponent(place.slice(1))) },
      motions: this.#serve(this.#own),
      drafts: this.#serve(this.#drafts),
      library: { answer: (/** @type {string} */ place) => fetch(`library${place}.txt`) },
      poses: { answer: (/** @type {string} */ _, /** @type {RequestInit} */ options) => this.#postures(options) },
      trial: { answer: (/** @type {string} */ _, /** @type {RequestInit} */ options) => this.#try(options) },
    };
  }

  /** @param {string} name name of a robot, empty for the NAO */
  async #describe(name) {
    return jsonOrRefusal(await this.questions.ask('robot', name), 404);
  }

  async #list() {
    const index = await (await fetch('library/index')).text();
    return Response.json({
      folder: 'this browser',
      own: entries(this.#own),
      drafts: entries(this.#drafts),
      library: index.split('\n').filter(Boolean),
      leftOut: [],
    });
  }

  /** @param {BrowserRepository} repository */
  #serve(repository) {
    return {
      answer: async (/** @type {string} */ place, /** @type {RequestInit} */ options) => {
        const name = decodeURIComponent(place.slice(1));
        if (name === '') {
          return this.#list();
        }
        const problem = nameProblem(composedName(name));
        if (problem !== '') {
          const refusal = `"${name}" is not a valid motion name: it ${problem}. Choose another one.`;
          return new Response(refusal, { status: 400 });
        }
        switch (options.method) {
          case 'PUT':
            return this.#write(repository, name, options);
          case 'DELETE':
            repository.remove(name);
            this.changed();
            return new Response('');
          default:
            return file(repository.read(name), name);
        }
      },
    };
  }

  /** @param {BrowserRepository} repository @param {string} name @param {RequestInit} options */
  async #write(repository, name, options) {
    const text = asText(await bodyOf(options));
    const known = new Headers(options.headers).get('Known-Version');
    if (known === null) {
      repository.write(name, text);
    }
    const answer = known === null ? new Response('') : repository.overwrite(name, text, known);
    this.changed();
    return answer;
  }

  /** @param {RequestInit} options */
  async #postures(options) {
    if (options.method === 'PUT') {
      this.#poses.write(POSES, asText(await bodyOf(options)));
      return new Response('');
    }
    return new Response(asBytes(this.#poses.read(POSES) ?? ''));
  }

  /** @param {RequestInit} options */
  async #try(options) {
    const text = decodeText(await bodyOf(options)).content;
    const start = new Headers(options.headers).get('Start') ?? 'standing';
    return jsonOrRefusal(await this.questions.ask('motionTrial', text, start), 400);
  }
}

/** @param {string} answer JSON, or a sentence that says why the request is refused @param {number} status status of a refusal */
function jsonOrRefusal(answer, status) {
  return new Response(answer, { status: answer.startsWith('{') ? 200 : status });
}

/** @param {string | null} text @param {string} name */
function file(text, name) {
  return text === null
    ? new Response(`There is no motion "${name}" in this browser.`, { status: 404 })
    : new Response(asBytes(text), { headers: { Version: versionOf(text) } });
}
