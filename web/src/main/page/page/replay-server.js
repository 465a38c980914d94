/** Answers what the room Replay asks its server: the recording of the world that this page shows, which grows with it. */
import { RecordingReader } from '../state/replay/recording-reader.js';

/** @typedef {import('../live/state-frame.js').Player} Player */

const NOT_HERE = 'The page keeps one recording, that of the world it shows; nothing else can be done with it here.';

export class ReplayServer {
  #number = 0;
  #bytes = new Uint8Array();
  /** @type {Record<string, {hinges: unknown[]}>} */
  #models = {};
  #reader = this.#freshReader();

  /** @param {import('./world-questions.js').WorldQuestions} questions */
  constructor(questions) {
    this.questions = questions;
  }

  /** The parts of a server that this one is, by the first words of their places. */
  get parts() {
    /** @param {(search: URLSearchParams) => object} reply */
    const json = (reply) => ({
      answer: async (/** @type {string} */ place, /** @type {RequestInit} */ { method = 'GET' }) => {
        if (method !== 'GET') {
          throw new Error(NOT_HERE);
        }
        await this.#readOn();
        return Response.json(reply(new URLSearchParams(place.split('?')[1])));
      },
    });
    return {
      recordings: json(() => ({ recordings: this.#number > 0 ? [this.#entry] : [] })),
      cards: json(() => this.#card),
      index: json((search) => this.#index(search)),
      pieces: { answer: async (/** @type {string} */ place) => this.#piece(new URLSearchParams(place.split('?')[1])) },
      models: { answer: async () => Response.json(await this.#allModels()) },
      notes: { answer: async () => new Response('') },
    };
  }

  async #allModels() {
    if (Object.keys(this.#models).length === 0) {
      this.#models = JSON.parse(await this.questions.ask('models'));
    }
    return this.#models;
  }

  #freshReader() {
    return new RecordingReader((type) => this.#models[type].hinges.length);
  }

  /** Fetches what is new. */
  async #readOn() {
    await this.#allModels();
    const number = await this.questions.ask('recordingNumber');
    if (number !== this.#number) {
      this.#number = number;
      this.#bytes = new Uint8Array();
      this.#reader = this.#freshReader();
    }
    const known = this.#bytes.length;
    const news = new Uint8Array((await this.questions.ask('recording', known)).buffer);
    if (this.#bytes.length === known && number === this.#number) {
      const all = new Uint8Array(known + news.length);
      all.set(this.#bytes);
      all.set(news, known);
      this.#bytes = all;
      this.#reader.push(news);
    }
  }

  get #entry() {
    return {
      name: `world-${this.#number}`,
      bytes: this.#bytes.length,
      running: true,
      agent: '',
      ofProject: true,
      starred: false,
      bookmarks: [],
    };
  }

  get #card() {
    const { moments, events, game } = this.#reader;
    return {
      count: moments.length,
      left: game.left,
      right: game.right,
      score: [game.scoreLeft, game.scoreRight],
      robots: Math.max(0, ...this.#rosters().map(({ robots }) => robots.length)),
      events,
      pitch: [12, 8],
      ball: [],
      ways: [],
    };
  }

  /** @returns {Array<{robots: Player[], cycles: number}>} who was there together, and how long */
  #rosters() {
    /** @type {Map<Player[], number>} */
    const cycles = new Map();
    for (const { robots } of this.#reader.moments) {
      cycles.set(robots, (cycles.get(robots) ?? 0) + 1);
    }
    return [...cycles].map(([robots, count]) => ({ robots, cycles: count }));
  }

  /** @param {URLSearchParams} search */
  #index(search) {
    const { moments, events, header } = this.#reader;
    return {
      count: moments.length,
      whole: true,
      events: events.slice(Number(search.get('events') ?? 0)),
      pieces: Number(search.get('pieces') ?? 0) === 0 && moments.length > 0 ? [0] : [],
      firstCycle: moments[0]?.cycle ?? 0,
      header,
      ball: [],
      ways: [],
      rosters: this.#rosters(),
    };
  }

  /** @param {URLSearchParams} search */
  #piece(search) {
    return new Response(this.#bytes.slice(Number(search.get('skip') ?? 0)));
  }
}
