/** A recording that is at hand: its bytes, and what stands in them as far as it was asked for. */
import { RecordingReader } from '../state/replay/recording-reader.js';

const FIRST_BYTES = 1 << 16;
const STEPS_PER_METRE = 10_000;
const MOST_BYTES = 400_000_000;
const MOST_PLACES = 256;

/** @typedef {import('../live/state-frame.js').Player} Player */

export class OpenRecording {
  #bytes = new Uint8Array(FIRST_BYTES);
  #read = 0;
  length = 0;
  /** What robots logged and drew, one line of JSON each. */
  notes = '';

  /** @param {(type: string) => number} hingesOf how many hinges a type of robot has */
  constructor(hingesOf) {
    this.hingesOf = hingesOf;
    this.reader = new RecordingReader(hingesOf);
  }

  /** @param {Uint8Array} bytes the next ones, unpacked */
  push(bytes) {
    if (this.length + bytes.length > MOST_BYTES) {
      throw new Error('The recording is larger than a page can show.');
    }
    if (this.length + bytes.length > this.#bytes.length) {
      const larger = new Uint8Array(Math.max(2 * this.#bytes.length, this.length + bytes.length));
      larger.set(this.#bytes);
      this.#bytes = larger;
    }
    this.#bytes.set(bytes, this.length);
    this.length += bytes.length;
  }

  /** @param {number} [from] @returns {Uint8Array<ArrayBuffer>} the bytes from there on */
  slice(from = 0) {
    return this.#bytes.slice(from, this.length);
  }

  /** Reads what has come. @throws {Error} if it is no recording; the message is meant for people */
  readOn() {
    this.reader.push(this.slice(this.#read));
    this.#read = this.length;
  }

  /** What stands on its card in the list of recordings. */
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

  /** @returns {Array<{robots: Player[], cycles: number}>} who was there together, and how long */
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

/** @param {[number, number][]} places @returns {[number, number][]} so few of them, evenly over the time, that they can be drawn */
function trail(places) {
  const every = Math.ceil(places.length / MOST_PLACES);
  return places.filter((_, i) => i % every === 0);
}
