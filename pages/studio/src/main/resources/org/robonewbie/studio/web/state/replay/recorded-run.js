/**
 * A recording of any length: its pieces are loaded on demand into an LRU cache. Pure except for the given loader.
 *
 * @typedef {import('./recording-reader.js').Moment} Moment
 * @typedef {import('./recording-reader.js').RecordedEvent} RecordedEvent
 * @typedef {import('../../live/state-frame.js').Player} Player
 *
 * @typedef {object} Growth state of a recording, or the part added to it
 * @property {number} count number of moments
 * @property {boolean} whole whether the entire recording has been indexed
 * @property {RecordedEvent[]} events
 * @property {number[]} pieces index of the first moment of each piece
 *
 * @typedef {object} Summary
 * @property {number} firstCycle
 * @property {Record<string, string>} header
 * @property {Array<[x: number, y: number]>} ball its path
 * @property {Array<{side: number, places: Array<[x: number, y: number]>}>} ways paths of the robots
 * @property {Array<{robots: Player[], cycles: number}>} rosters
 * @property {Record<string, import('../kinematics.js').RobotModel>} [models] models that the recording defines
 *
 * @typedef {{reader: RecordingReader, bytes: number, loading: Promise<void> | undefined}} Piece
 */
import { partitionPoint } from '../partition-point.js';
import { RecordingReader } from './recording-reader.js';

/** Maximum number of loaded pieces, about 40 megabytes. */
const MAX_PIECES = 36;
const PAUSE_MILLISECONDS = 1000;

/**
 * Rejects with the problem after a pause, so that a request to a server that did not respond is not repeated immediately.
 *
 * @param {unknown} problem
 * @returns {Promise<void>}
 */
const pause = (problem) => new Promise((_, fail) => setTimeout(() => fail(problem), PAUSE_MILLISECONDS));

export class RecordedRun {
  /** Loaded pieces, least recently used first. @type {Map<number, Piece>} */
  #pieces = new Map();
  /** @type {Map<string, Player[]>} */
  #rosters = new Map();
  /** @type {Record<string, import('../kinematics.js').RobotModel>} */
  #models = {};

  /**
   * @param {(type: string) => number} hingesOf number of hinges of a robot type
   * @param {(piece: number, skip: number) => Promise<Uint8Array>} fetchPiece
   * @param {() => void} grown called when moments have been loaded
   */
  constructor(hingesOf, fetchPiece, grown) {
    this.hingesOf = hingesOf;
    this.fetchPiece = fetchPiece;
    this.grown = grown;
    this.count = 0;
    /** Incremented whenever moments have been loaded. */
    this.arrived = 0;
    /** @type {number[]} */
    this.starts = [];
    /** @type {RecordedEvent[]} */
    this.events = [];
    /** @type {Summary} */
    this.summary = { firstCycle: 0, header: {}, ball: [], ways: [], rosters: [] };
  }

  get header() {
    return this.summary.header;
  }

  get firstCycle() {
    return this.summary.firstCycle;
  }

  /** @param {Growth} growth */
  grow({ count, events, pieces }) {
    this.count = count;
    this.events.push(...events);
    this.starts.push(...pieces);
  }

  /** @param {number} index @returns {Moment | undefined} the moment if it is loaded; otherwise undefined, and loading starts */
  at(index) {
    const piece = this.#pieceOf(index);
    const moment = this.#pieces.get(piece)?.reader.moments[index - this.starts[piece]];
    if (piece >= 0) {
      this.#want(piece, index);
    }
    if (moment) {
      this.#wantNext(piece, index);
    }
    return moment;
  }

  /** @param {number} index @returns {Promise<Moment | undefined>} the moment once it is loaded */
  async ready(index) {
    const piece = this.#pieceOf(index);
    await this.#want(piece, index);
    return this.at(index);
  }

  /**
   * @param {number} index
   * @param {number} reach moments
   * @returns {Moment[]} the loaded moments around this one; loading of the others starts
   */
  around(index, reach) {
    const [from, to] = [Math.max(0, index - reach), Math.min(this.count - 1, index + reach)];
    const moments = [];
    for (let piece = this.#pieceOf(from); piece >= 0 && this.starts[piece] <= to; piece++) {
      const start = this.starts[piece];
      this.#want(piece, Math.min(to, this.#endOf(piece) - 1));
      const there = this.#pieces.get(piece)?.reader.moments ?? [];
      moments.push(...there.slice(Math.max(0, from - start), to + 1 - start));
    }
    return moments;
  }

  /** @param {number} from @param {number} to @returns {AsyncGenerator<Moment[]>} all moments of a range, piece by piece */
  async *all(from = 0, to = this.count - 1) {
    for (let piece = this.#pieceOf(from); piece >= 0 && this.starts[piece] <= to; piece++) {
      const start = this.starts[piece];
      await this.#want(piece, Math.min(to, this.#endOf(piece) - 1));
      const { reader } = /** @type {Piece} */ (this.#pieces.get(piece));
      yield reader.moments.slice(Math.max(0, from - start), to + 1 - start);
    }
  }

  /** @param {number} piece @param {number} index index of the displayed moment */
  #wantNext(piece, index) {
    const [start, end] = [this.starts[piece], this.#endOf(piece)];
    const neighbour = index - start > (end - start) / 2 ? piece + 1 : piece - 1;
    if (neighbour >= 0 && neighbour < this.starts.length) {
      this.#want(neighbour, Math.min(this.count, this.#endOf(neighbour)) - 1);
    }
  }

  /** @param {number} piece @returns {number} the index after its last moment */
  #endOf(piece) {
    return this.starts[piece + 1] ?? this.count;
  }

  /** @param {number} index @returns {number} the piece that contains a moment, -1 if there is none */
  #pieceOf(index) {
    return partitionPoint(this.starts.length, (piece) => this.starts[piece] <= index) - 1;
  }

  /** Loads a piece up to a moment, unless it is already loaded. @param {number} number @param {number} index @returns {Promise<void>} */
  #want(number, index) {
    const part = { rosters: this.#rosters, models: this.#models, isBegun: number > 0 };
    const piece = this.#pieces.get(number) ?? {
      reader: new RecordingReader(this.hingesOf, part),
      bytes: 0,
      loading: undefined,
    };
    this.#pieces.delete(number);
    this.#pieces.set(number, piece);
    if (!piece.loading && this.starts[number] + piece.reader.moments.length <= index) {
      piece.loading = this.#load(number, piece, index)
        .catch(pause)
        .finally(() => {
          piece.loading = undefined;
        });
      piece.loading.catch(() => {});
      this.#forgetOld();
    }
    return piece.loading ?? Promise.resolve();
  }

  /** @param {number} number @param {Piece} piece @param {number} index */
  async #load(number, piece, index) {
    let bytes = await this.fetchPiece(number, piece.bytes);
    while (bytes.length > 0) {
      piece.bytes += bytes.length;
      piece.reader.push(bytes);
      const isThere = this.starts[number] + piece.reader.moments.length > index;
      bytes = isThere ? new Uint8Array() : await this.fetchPiece(number, piece.bytes);
    }
    this.arrived++;
    this.grown();
  }

  #forgetOld() {
    for (const [number, { loading }] of this.#pieces) {
      if (this.#pieces.size > MAX_PIECES && !loading) {
        this.#pieces.delete(number);
      }
    }
  }
}
