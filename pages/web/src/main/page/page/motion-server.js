/** Answers what the motion editor asks its server: motions of the browser, those of the library, and trials on a physical robot. */
import { decodeText } from '../state/decoded-text.js';
import { asBytes, asText, BrowserRepository, versionOf } from './browser-repository.js';

const POSES = 'poses';

/** @param {RequestInit} options */
const bodyOf = async (options) => new Uint8Array(await new Response(options.body).arrayBuffer());

/** @param {BrowserRepository} shelf */
const entries = (shelf) => shelf.list.map(({ path, version }) => ({ name: path, version }));

export class MotionServer {
  #own = new BrowserRepository('robonewbie-page-motion:');
  #drafts = new BrowserRepository('robonewbie-page-motion-draft:');
  #poses = new BrowserRepository('robonewbie-page-postures:');
  /** @type {Promise<string> | undefined} */
  #robot;
  /** Called when a motion of this browser was saved or removed. */
  changed = () => {};

  /** @param {import('./world-questions.js').WorldQuestions} questions */
  constructor(questions) {
    this.questions = questions;
  }

  /** @returns {[string, Int8Array][]} name and bytes of each motion of this browser */
  get own() {
    return this.#own.list.map(({ path }) => [path, new Int8Array(asBytes(this.#own.read(path) ?? '').buffer)]);
  }

  /** The parts of a server that this one is, by the first words of their places. */
  get parts() {
    return {
      robot: { answer: () => this.#describe() },
      motions: this.#shelf(this.#own),
      drafts: this.#shelf(this.#drafts),
      library: { answer: (/** @type {string} */ place) => fetch(`library${place}.txt`) },
      poses: { answer: (/** @type {string} */ _, /** @type {RequestInit} */ options) => this.#postures(options) },
      trial: { answer: (/** @type {string} */ _, /** @type {RequestInit} */ options) => this.#try(options) },
    };
  }

  async #describe() {
    this.#robot ??= this.questions.ask('robot');
    return new Response(await this.#robot);
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

  /** @param {BrowserRepository} shelf */
  #shelf(shelf) {
    return {
      answer: async (/** @type {string} */ place, /** @type {RequestInit} */ options) => {
        const name = decodeURIComponent(place.slice(1));
        if (name === '') {
          return this.#list();
        }
        switch (options.method) {
          case 'PUT':
            return this.#write(shelf, name, options);
          case 'DELETE':
            shelf.remove(name);
            this.changed();
            return new Response('');
          default:
            return file(shelf.read(name), name);
        }
      },
    };
  }

  /** @param {BrowserRepository} shelf @param {string} name @param {RequestInit} options */
  async #write(shelf, name, options) {
    const text = asText(await bodyOf(options));
    const known = new Headers(options.headers).get('Known-Version');
    if (known === null) {
      shelf.write(name, text);
    }
    const answer = known === null ? new Response('') : shelf.overwrite(name, text, known);
    this.changed();
    return answer;
  }

  /** @param {RequestInit} options */
  async #postures(options) {
    if (options.method === 'PUT') {
      this.#poses.write(POSES, asText(await bodyOf(options)));
    }
    return new Response(asBytes(this.#poses.read(POSES) ?? ''));
  }

  /** @param {RequestInit} options */
  async #try(options) {
    const text = decodeText(await bodyOf(options)).content;
    const start = new Headers(options.headers).get('Start') ?? 'standing';
    const result = await this.questions.ask('motionTrial', text, start);
    return new Response(result, { status: result.startsWith('{') ? 200 : 400 });
  }
}

/** @param {string | null} text @param {string} name */
function file(text, name) {
  return text === null
    ? new Response(`There is no motion "${name}" in this browser.`, { status: 404 })
    : new Response(asBytes(text), { headers: { Version: versionOf(text) } });
}
