/** Local replacement for the recording server, based on the recordings of this browser. */
import { simSparkLog } from './recording-log.js';

/**
 * @typedef {import('./open-recording.js').OpenRecording} OpenRecording
 * @typedef {(name: string, wish: URLSearchParams, isPut: boolean) => Promise<unknown>} Reply
 */

export class ReplayServer {
  /** @param {import('./page-recordings.js').PageRecordings} recordings @param {() => Promise<object>} models */
  constructor(recordings, models) {
    this.recordings = recordings;
    this.models = models;
  }

  /** Request handlers by the first segment of their path. */
  get parts() {
    const { recordings } = this;
    return {
      recordings: part((name, wish, isPut) => this.#keep(name, wish, isPut), {
        read: async () => Response.json({ recordings: await recordings.list() }),
      }),
      cards: part((name) => this.#card(name)),
      index: part((name, wish) => this.#index(name, wish)),
      pieces: part(async (name, wish) => new Response((await recordings.open(name)).slice(number(wish, 'skip')))),
      log: part(async (name) => new Response(await simSparkLog(await recordings.file(name)))),
      notes: part((name, wish) => this.#notes(name, number(wish, 'skip'))),
      models: part(() => this.models()),
      stars: part((name, _, isPut) => recordings.star(name, isPut)),
      bookmarks: part((name, wish, isPut) => this.#mark(name, wish, isPut)),
    };
  }

  /** @param {string} name @param {URLSearchParams} wish @param {boolean} isPut */
  async #keep(name, wish, isPut) {
    const was = wish.get('was');
    if (!isPut) {
      await this.recordings.remove(name);
    } else if (was === null) {
      await this.recordings.bringBack(name);
    } else {
      await this.recordings.rename(was, name);
    }
  }

  /** @param {string} name */
  async #card(name) {
    return (await this.recordings.open(name)).card;
  }

  /** @param {string} name @param {URLSearchParams} wish */
  async #index(name, wish) {
    const recording = await this.recordings.open(name);
    const { moments, header } = recording.reader;
    const card = recording.card;
    return {
      ...card,
      whole: true,
      events: card.events.slice(number(wish, 'events')),
      pieces: number(wish, 'pieces') === 0 && moments.length > 0 ? [0] : [],
      firstCycle: moments[0]?.cycle ?? 0,
      header,
      rosters: recording.rosters,
    };
  }

  /** @param {string} name @param {number} skip number of bytes that the page already has */
  async #notes(name, skip) {
    const { notes } = await this.recordings.open(name);
    return new Response(new TextEncoder().encode(notes).slice(skip));
  }

  /** @param {string} name @param {URLSearchParams} wish @param {boolean} isPut */
  async #mark(name, wish, isPut) {
    const seconds = Number(wish.get('seconds'));
    if (isPut) {
      await this.recordings.addBookmark(name, { seconds, note: wish.get('note') ?? '' });
    } else {
      await this.recordings.removeBookmark(name, seconds);
    }
  }
}

/**
 * @param {Reply} reply
 * @param {{read?: () => Promise<Response>}} [list] handler for requests without a name
 */
function part(reply, { read } = {}) {
  return {
    answer: async (/** @type {string} */ place, /** @type {RequestInit} */ { method = 'GET' }) => {
      const [path, search] = place.split('?');
      const name = path.split('/').slice(1).map(decodeURIComponent).join('/');
      if (read && name === '') {
        return read();
      }
      const answer = await reply(name, new URLSearchParams(search), method === 'PUT');
      return answer instanceof Response ? answer : Response.json(answer ?? {});
    },
  };
}

/** @param {URLSearchParams} wish @param {string} name */
const number = (wish, name) => Number(wish.get(name) ?? 0);
