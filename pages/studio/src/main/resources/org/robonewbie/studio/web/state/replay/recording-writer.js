/**
 * Writes moments as a recording, without the commanded speeds, which make up half of a recording with a lot of movement.
 * docs/recording-format.md describes the format. Pure.
 *
 * @typedef {import('./recording-reader.js').Moment} Moment
 * @typedef {import('./recording-reader.js').RecordedEvent} RecordedEvent
 */
import { measuresOf } from './recorded-things.js';
import { KIND, MAGIC, POSE_NUMBERS, SIDES, VERSION } from './recording-source.js';

const CYCLES_PER_SECOND = 50;

/** @param {string} type name such as TYPE_0 */
const typeNumber = (type) => Number(type.split('_')[1]);

export class RecordingWriter {
  #bytes = new Uint8Array(1 << 16);
  #length = 0;
  /** @type {Moment | undefined} */
  #last;
  /** The numbers of the previous moment by robot id; -1 for the ball. @type {Map<number, Int32Array>} */
  #tracks = new Map();

  /** @param {Record<string, string>} header @param {(type: string) => number} hingesOf */
  constructor(header, hingesOf) {
    /** Types whose models have been written. @type {Record<string, import('../kinematics.js').RobotModel>} */
    this.models = {};
    /** @param {string} type */
    this.hingesOf = (type) => this.models[type]?.hinges.length ?? hingesOf(type);
    this.#raw(new TextEncoder().encode(MAGIC));
    this.#unsigned(VERSION);
    const lines = Object.entries(header).map((entry) => entry.join('='));
    this.#record(KIND.HEADER, () => this.#text(lines.join('\n')));
  }

  /** @param {Moment} moment @param {readonly RecordedEvent[]} events events of this moment */
  write(moment, events) {
    for (const { kind, text } of events) {
      this.#record(KIND.EVENT, () => this.#text(`${kind} ${text}`));
    }
    const { game, robots } = moment;
    if (game !== this.#last?.game) {
      this.#record(KIND.GAME, () => {
        this.#text(game.playMode);
        [game.half, game.scoreLeft, game.scoreRight].forEach((each) => this.#unsigned(each));
        [game.left, game.right].forEach((each) => this.#text(each));
      });
    }
    this.#defineModels(moment);
    if (robots !== this.#last?.robots) {
      this.#record(KIND.ROBOTS, () => this.#roster(robots));
    }
    this.#standing(moment);
    this.#record(KIND.CYCLE, () => this.#cycle(moment));
    this.#last = moment;
  }

  /** @returns {Uint8Array<ArrayBuffer>} all bytes written */
  get bytes() {
    return this.#bytes.slice(0, this.#length);
  }

  /** @param {Moment} moment */
  #defineModels({ models = {} }) {
    for (const [type, model] of Object.entries(models)) {
      if (!(type in this.models)) {
        this.models[type] = model;
        this.#record(KIND.MODEL, () => {
          [typeNumber(type), model.hinges.length].forEach((each) => this.#unsigned(each));
          this.#text(JSON.stringify(model));
        });
      }
    }
  }

  /** @param {Moment['robots']} robots */
  #roster(robots) {
    this.#unsigned(robots.length);
    for (const { id, type, side, number, team } of robots) {
      [id, typeNumber(type), SIDES.indexOf(side), number].forEach((each) => this.#unsigned(each));
      this.#text(team);
    }
  }

  /** Writes all objects again if one of them has moved, which is rare. @param {Moment} moment */
  #standing({ things = [] }) {
    if (things === this.#last?.things || (things.length === 0 && !this.#last?.things?.length)) {
      return;
    }
    this.#record(KIND.THINGS, () => {
      this.#unsigned(things.length);
      for (const each of things) {
        this.#text(each.thing.name);
        measuresOf(each).forEach((number) => this.#unsigned(number));
        each.pose.forEach((number) => this.#signed(number));
      }
    });
  }

  /** @param {Moment} moment */
  #cycle({ cycle, gameTime, numbers, robots }) {
    const ticks = (/** @type {number} */ seconds) => Math.round(seconds * CYCLES_PER_SECOND);
    this.#unsigned(cycle);
    this.#signed(ticks(gameTime) - ticks(this.#last?.gameTime ?? 0));
    this.#track(-1, numbers.subarray(0, POSE_NUMBERS));
    let at = POSE_NUMBERS;
    for (const { id, type } of robots) {
      const size = POSE_NUMBERS + this.hingesOf(type);
      this.#track(id, numbers.subarray(at, at + size));
      at += size;
    }
  }

  /** @param {number} id @param {Int32Array} numbers */
  #track(id, numbers) {
    const last = this.#tracks.get(id);
    const known = last?.length === numbers.length ? last : undefined;
    numbers.forEach((number, i) => this.#signed(number - (known?.[i] ?? 0)));
    this.#tracks.set(id, numbers);
  }

  /** @param {number} kind @param {() => void} fill */
  #record(kind, fill) {
    const outer = [this.#bytes, this.#length];
    this.#bytes = new Uint8Array(1 << 10);
    this.#length = 0;
    fill();
    const content = this.#bytes.subarray(0, this.#length);
    [this.#bytes, this.#length] = /** @type {[Uint8Array<ArrayBuffer>, number]} */ (outer);
    this.#byte(kind);
    this.#unsigned(content.length);
    this.#raw(content);
  }

  /** @param {string} text */
  #text(text) {
    const encoded = new TextEncoder().encode(text);
    this.#unsigned(encoded.length);
    this.#raw(encoded);
  }

  /** @param {number} value */
  #signed(value) {
    this.#unsigned(value >= 0 ? 2 * value : -2 * value - 1);
  }

  /** @param {number} value */
  #unsigned(value) {
    let rest = value;
    while (rest > 127) {
      this.#byte((rest % 128) + 128);
      rest = Math.floor(rest / 128);
    }
    this.#byte(rest);
  }

  /** @param {number} value */
  #byte(value) {
    this.#room(1);
    this.#bytes[this.#length++] = value;
  }

  /** @param {Uint8Array} content */
  #raw(content) {
    this.#room(content.length);
    this.#bytes.set(content, this.#length);
    this.#length += content.length;
  }

  /** @param {number} count */
  #room(count) {
    if (this.#length + count > this.#bytes.length) {
      const larger = new Uint8Array(Math.max(2 * this.#bytes.length, this.#length + count));
      larger.set(this.#bytes.subarray(0, this.#length));
      this.#bytes = larger;
    }
  }
}
