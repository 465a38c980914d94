/** This browser's recordings: the one of the displayed world is still growing; the others are kept until space is needed. */
import { unpack } from '../replay/unpack.js';
import { dateName } from './date-name.js';
import { OpenRecording } from './open-recording.js';
import { pack } from './pack.js';

/** @typedef {import('./recording-store.js').Entry} Entry */

const MAX_BYTES = 100_000_000;
/** Maximum size of one recording: about one hour with one robot. */
const MAX_BYTES_OF_ONE = 40_000_000;
const SAVE_MILLISECONDS = 10_000;
const HOUR_MILLISECONDS = 3_600_000;
const MAX_OPEN = 3;

export class PageRecordings {
  /** @type {Map<number, Entry>} */
  #entries = new Map();
  /** The most recently opened recordings, and the growing one. @type {Map<number, Promise<OpenRecording>>} */
  #open = new Map();
  /** @type {{entry: Entry, content: OpenRecording, savedBytes: number, savedNotes: number} | undefined} */
  #running;
  #work;
  /** Resolves when the last change from the replay service has been stored. @type {Promise<void>} */
  #change = Promise.resolve();
  /** Name of the agent in the next world. */
  agent = '';

  /**
   * @param {import('./recording-store.js').RecordingStore} store
   * @param {import('./world-questions.js').WorldQuestions} questions
   */
  constructor(store, questions) {
    this.store = store;
    this.questions = questions;
    this.#work = store.entries().then((entries) => this.#begin(entries));
    setInterval(() => this.#save(), SAVE_MILLISECONDS);
    document.addEventListener('visibilitychange', () => document.hidden && this.#save(true));
  }

  /** @param {Entry[]} entries entries from earlier visits */
  async #begin(entries) {
    const earlier = Date.now() - HOUR_MILLISECONDS;
    for (const entry of entries) {
      if (entry.removedAt > 0 && entry.removedAt < earlier) {
        await this.store.remove(entry.id);
      } else {
        this.#entries.set(entry.id, entry);
      }
    }
  }

  /** @param {Uint8Array} bytes next part of the recording @param {boolean} isFirst whether it starts another recording */
  receive(bytes, isFirst) {
    this.#enqueue(async () => {
      if (isFirst || !this.#running) {
        await this.#write();
        this.#running = await this.#create();
      }
      if (this.#running.content.length + bytes.length <= MAX_BYTES_OF_ONE) {
        this.#running.content.push(bytes);
      }
    });
  }

  /** @param {string} line log entry or drawing of a robot */
  note(line) {
    this.#enqueue(async () => {
      if (this.#running) {
        this.#running.content.notes += `${line}\n`;
      }
    });
  }

  async #create() {
    const entry = this.#fresh(dateName(new Date()), this.agent);
    const content = new OpenRecording();
    this.#keepOpen(entry.id, Promise.resolve(content));
    await this.#makeRoom();
    return { entry, content, savedBytes: 0, savedNotes: 0 };
  }

  /** @param {string} name @param {string} agent */
  #fresh(name, agent) {
    const id = Math.max(Date.now(), ...[...this.#entries.keys()].map((each) => each + 1));
    const free = this.#freeName(name);
    const entry = { id, name: free, agent, starred: false, bookmarks: [], bytes: 0, pieces: 0, removedAt: 0 };
    this.#entries.set(id, entry);
    return entry;
  }

  /** @param {string} name */
  #freeName(name) {
    for (let i = 1; ; i++) {
      const free = i === 1 ? name : `${name} (${i})`;
      if (![...this.#entries.values()].some((entry) => entry.name === free)) {
        return free;
      }
    }
  }

  /** @param {boolean} [hurry] whether the page may be about to close, which leaves no time for compression */
  #save(hurry = false) {
    this.#enqueue(() => this.#write(hurry));
  }

  /** Stores the data that has arrived since the last write. @param {boolean} [hurry] */
  async #write(hurry = false) {
    const running = this.#running;
    if (!running || running.savedBytes === running.content.length) {
      return;
    }
    const { entry, content } = running;
    const notes = content.notes.slice(running.savedNotes);
    const bytes = content.slice(running.savedBytes);
    running.savedBytes += bytes.length;
    running.savedNotes += notes.length;
    await this.#add(entry, { bytes: hurry ? bytes : await pack(bytes), isPacked: !hurry, notes });
  }

  /** @param {Entry} entry @param {import('./recording-store.js').Piece} piece */
  async #add(entry, piece) {
    entry.bytes += piece.bytes.length;
    entry.pieces += 1;
    await this.store.put(entry, piece);
  }

  /** Removes the oldest recordings until the others fit; starred ones are kept and do not count. */
  async #makeRoom() {
    let sum = 0;
    for (const { id, starred, bytes } of [...this.#entries.values()].reverse()) {
      sum += starred ? 0 : bytes;
      if (!starred && sum > MAX_BYTES) {
        await this.#forget(id);
      }
    }
  }

  /** @param {number} id */
  async #forget(id) {
    this.#entries.delete(id);
    this.#open.delete(id);
    await this.store.remove(id);
  }

  /** Queues a task; a failed task does not stop the others. @param {() => Promise<void>} work */
  #enqueue(work) {
    this.#work = this.#work.then(work).catch(() => {});
  }

  /**
   * Sends a request to the replay service.
   *
   * @param {import('./page-server.js').ServiceRequest} request
   * @returns {Promise<string>} JSON, or why the request was rejected
   */
  async answer(request) {
    await this.#work;
    const [kind, ...names] = request.path;
    if (kind === 'cards' || kind === 'index') {
      await this.#passBytes(names.join('/'));
    }
    const recordings = [...this.#entries.values()]
      .reverse()
      .map((entry) => ({ ...entry, running: entry === this.#running?.entry }));
    const result = await this.questions.ask('answer', 'recordings', JSON.stringify({ ...request, recordings }));
    await this.#change;
    return result;
  }

  /** Passes to the replay service those bytes of a recording that it has not read yet. @param {string} name */
  async #passBytes(name) {
    const content = await this.open(name);
    const id = String(this.#find(name).id);
    do {
      const bytes = new Int8Array(content.slice(content.read).buffer);
      content.read = await this.questions.ask('readRecording', id, content.read, bytes);
    } while (content.read < content.length);
  }

  /** Stores a change from the replay service. @param {string} text id of the recording and changed metadata as a JSON object */
  keep(text) {
    const { id, ...change } = JSON.parse(text);
    const entry = this.#entries.get(id);
    this.#change = entry ? this.store.put(Object.assign(entry, change)) : this.#change;
  }

  /** @param {string} name */
  #find(name) {
    const entry = [...this.#entries.values()].find((each) => each.name === name);
    if (!entry) {
      throw new Error('This recording no longer exists. Choose another one.');
    }
    return entry;
  }

  /** @param {string} name @returns {Promise<OpenRecording>} the recording */
  async open(name) {
    await this.#work;
    const { id } = this.#find(name);
    const opened = this.#open.get(id) ?? this.#load(id);
    this.#keepOpen(id, opened);
    return opened;
  }

  /** @param {number} id */
  async #load(id) {
    const content = new OpenRecording();
    for (const { bytes, isPacked, notes } of await this.store.pieces(id)) {
      await (isPacked ? unpack([bytes], (part) => content.push(part)) : content.push(bytes));
      content.notes += notes;
    }
    return content;
  }

  /** @param {number} id @param {Promise<OpenRecording>} content */
  #keepOpen(id, content) {
    this.#open.delete(id);
    this.#open.set(id, content);
    for (const each of [...this.#open.keys()].filter((other) => other !== this.#running?.entry.id)) {
      if (this.#open.size > MAX_OPEN && each !== id) {
        this.#open.delete(each);
      }
    }
  }

  /** @param {string} name @returns {Promise<Blob>} the recording as a RoboNewbie file */
  async file(name) {
    return new Blob([await pack((await this.open(name)).slice())], { type: 'application/gzip' });
  }

  /**
   * Imports a recording.
   *
   * @param {string} name
   * @param {Uint8Array} packed
   * @returns {Promise<string>} its name in this browser
   * @throws {Error} if it is not a recording; the message is meant for the user
   */
  async take(name, packed) {
    const content = new OpenRecording();
    await unpack([packed], (bytes) => content.push(bytes));
    await this.#work;
    const entry = this.#fresh(name.replace(/\.rec$/, ''), '');
    this.#keepOpen(entry.id, Promise.resolve(content));
    try {
      const card = await this.answer({ method: 'GET', path: ['cards', entry.name], parameters: {} });
      if (JSON.parse(card).count === 0) {
        throw new Error(`“${name}” is not a RoboNewbie recording, or it is damaged.`);
      }
      await this.#add(entry, { bytes: packed, isPacked: true, notes: '' });
    } catch (failure) {
      this.#entries.delete(entry.id);
      throw failure;
    }
    return entry.name;
  }
}
