/** An open recording: its bytes, and its parsed content as far as requested. */
import { RecordingReader } from '../state/replay/recording-reader.js';

const FIRST_BYTES = 1 << 16;
const STEPS_PER_METRE = 10_000;
const MAX_BYTES = 400_000_000;
const MAX_PLACES = 256;

/** @typedef {import('../live/state-frame.js').Player} Player */

export class OpenRecording {
  #bytes = new Uint8Array(FIRST_BYTES);
  #read = 0;
  length = 0;
  /** Logs and drawings of the robots, one line of JSON each. */
  notes = '';

  /** @param {(type: string) => number} hingesOf number of hinges of a robot type */
  constructor(hingesOf) {
    this.hingesOf = hingesOf;
    this.reader = new RecordingReader(hingesOf);
  }

  /** @param {Uint8Array} bytes next decompressed bytes */
  push(bytes) {
    if (this.length + bytes.length > MAX_BYTES) {
      throw new Error('The recording is too large for this page.');
    }
    if (this.length + bytes.length > this.#bytes.length) {
      const larger = new Uint8Array(Math.max(2 * this.#bytes.length, this.length + bytes.length));
      larger.set(this.#bytes);
      this.#bytes = larger;
    }
    this.#bytes.set(bytes, this.length);
    this.length += bytes.length;
  }

  /** @param {number} [from] @returns {Uint8Array<ArrayBuffer>} the bytes from an offset on */
  slice(from = 0) {
    return this.#bytes.slice(from, this.length);
  }

  /** Parses the new bytes. @throws {Error} if it is not a recording; the message is meant for the user */
  readOn() {
    this.reader.push(this.slice(this.#read));
    this.#read = this.length;
  }

  /** Summary for its card in the list of recordings. */
  get card() {
    const { moments, events, game, header } = this.reader;
    return {
      count: moments.length,
      left: game.left,
      right: game.right,
      score: [game.scoreLeft, game.scoreRight],
      robots: Math.max(0, ...this.rosters.map(({ robots }) => robots.length)),
      events,
      pitch: [Number(header.FieldLength ?? 12), Number(header.FieldWidth ?? 8)],
      ball: trail(moments.map(({ numbers }) => placeAt(numbers, 0))),
      ways: this.#ways(),
    };
  }

  /** @returns {Array<{robots: Player[], cycles: number}>} rosters and how long each was present */
  get rosters() {
    /** @type {Map<Player[], number>} */
    const cycles = new Map();
    for (const { robots } of this.reader.moments) {
      cycles.set(robots, (cycles.get(robots) ?? 0) + 1);
    }
    return [...cycles].map(([robots, count]) => ({ robots, cycles: count }));
  }

  #ways() {
    /** @type {Map<number, {side: number, places: [number, number][]}>} */
    const ways = new Map();
    for (const { robots, numbers } of this.reader.moments) {
      let at = POSE_NUMBERS;
      for (const { id, side, type } of robots) {
        const way = ways.get(id) ?? { side: SIDES.indexOf(side), places: [] };
        ways.set(id, way);
        way.places.push(placeAt(numbers, at));
        at += POSE_NUMBERS + this.hingesOf(type);
      }
    }
    return [...ways.values()].map(({ side, places }) => ({ side, places: trail(places) }));
  }
}

const POSE_NUMBERS = 7;
const SIDES = ['', 'left', 'right'];

/** @param {Int32Array} numbers @param {number} at @returns {[x: number, y: number]} metres */
const placeAt = (numbers, at) => [numbers[at] / STEPS_PER_METRE, numbers[at + 1] / STEPS_PER_METRE];

/** @param {[number, number][]} places @returns {[number, number][]} thinned out at equal intervals for drawing */
function trail(places) {
  const every = Math.ceil(places.length / MAX_PLACES);
  return places.filter((_, i) => i % every === 0);
}
