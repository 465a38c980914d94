/** Fetches recordings from the studio's server and unpacks them while they come; a run that goes on is followed. */
import { notesOf, picturesOf } from '../state/replay/notes.js';
import { RecordingReader } from '../state/replay/recording-reader.js';
import { DrawingMemory } from '../state/robot/drawing-memory.js';

/**
 * @typedef {object} RecordingEntry
 * @property {string} name
 * @property {number} bytes
 * @property {boolean} running
 */

const FOLLOW_MILLISECONDS = 1000;

/** @param {string} token @param {string} path */
async function ask(token, path) {
  const answer = await fetch(`api/${path}`, { headers: { 'Studio-Token': token } });
  if (!answer.ok) {
    throw new Error(await answer.text());
  }
  return answer;
}

/** @param {string} token @returns {Promise<{folder?: string, recordings: RecordingEntry[]}>} */
export async function listRecordings(token) {
  return (await ask(token, 'recordings')).json();
}

/**
 * @typedef {object} RecordingCard what a recording holds
 * @property {number} seconds
 * @property {string} left name of a team, or empty
 * @property {string} right
 * @property {[number, number]} score
 * @property {number} robots
 * @property {Record<string, number>} events how often something happened
 * @property {[number, number]} pitch
 * @property {[number, number]} ball at its end
 * @property {Array<[x: number, y: number, side: number]>} places of the robots at its end
 */

/** @param {string} token @param {string} name @returns {Promise<RecordingCard>} */
export async function loadCard(token, name) {
  return (await ask(token, `cards/${encodeURIComponent(name)}`)).json();
}

/** @param {string} token @returns {Promise<Record<string, import('../state/kinematics.js').RobotModel>>} */
export async function loadModels(token) {
  return (await ask(token, 'models')).json();
}

/** @param {string} token @param {string} name @returns {Promise<Blob>} the recording as the log of a SimSpark server, packed */
export async function loadLog(token, name) {
  return (await ask(token, `log/${encodeURIComponent(name)}`)).blob();
}

/** @param {string} token @param {string} name @returns {Promise<string>} what robots logged and drew, one line of JSON each */
async function loadNotes(token, name) {
  return (await ask(token, `notes/${encodeURIComponent(name)}`)).text();
}

/** One recording that is being read. */
export class RecordingFile {
  /**
   * @param {string} token
   * @param {string} name
   * @param {Record<string, import('../state/kinematics.js').RobotModel>} models
   * @param {() => void} grown
   */
  constructor(token, name, models, grown) {
    this.token = token;
    this.name = name;
    this.grown = grown;
    this.reader = new RecordingReader((type) => models[type].hinges.length);
    /** @type {import('../state/replay/recording-reader.js').RecordedEvent[]} lines of logs */
    this.notes = [];
    /** @type {string[]} lines of telemetry with what robots drew */
    this.pictures = [];
    this.drawings = new DrawingMemory(Infinity);
    this.read = 0;
    /** @type {Uint8Array[]} the packed bytes as they came */
    this.packed = [];
    this.open = true;
    /** Whether all has come that there was when it was asked for. */
    this.isWhole = false;
    this.timer = 0;
    const unpacking = new DecompressionStream('gzip');
    this.writer = unpacking.writable.getWriter();
    this.done = this.#unpack(unpacking.readable.getReader());
  }

  /** @param {boolean} follows whether the run goes on */
  async load(follows) {
    for (let size = await this.#fetchMore(); size > 0 && this.open; size = await this.#fetchMore()) {
      this.grown();
    }
    this.#note(await loadNotes(this.token, this.name));
    this.isWhole = true;
    this.grown();
    if (follows && this.open) {
      this.timer = window.setTimeout(() => this.load(true).catch(() => {}), FOLLOW_MILLISECONDS);
    }
  }

  /** @param {string} lines what robots logged and drew */
  #note(lines) {
    this.notes = notesOf(lines, this.reader.moments[0]?.cycle ?? 0);
    const pictures = picturesOf(lines);
    this.drawings.hear(pictures.slice(this.pictures.length));
    this.pictures = pictures;
  }

  /** All that the time line marks. */
  get events() {
    return [...this.reader.events, ...this.notes];
  }

  close() {
    this.open = false;
    clearTimeout(this.timer);
    this.writer.abort().catch(() => {});
  }

  async #fetchMore() {
    const answer = await ask(this.token, `recordings/${encodeURIComponent(this.name)}?from=${this.read}`);
    const bytes = new Uint8Array(await answer.arrayBuffer());
    this.read += bytes.length;
    if (bytes.length > 0) {
      this.packed.push(bytes);
      await this.writer.write(bytes);
    }
    return bytes.length;
  }

  /** @param {ReadableStreamDefaultReader<Uint8Array>} unpacked */
  async #unpack(unpacked) {
    try {
      for (let part = await unpacked.read(); !part.done; part = await unpacked.read()) {
        this.reader.push(part.value);
        this.grown();
      }
    } catch (error) {
      if (this.open) {
        this.problem = /** @type {Error} */ (error).message;
        this.grown();
      }
    }
  }
}
