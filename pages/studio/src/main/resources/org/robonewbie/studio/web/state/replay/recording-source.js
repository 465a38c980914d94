/** Primitive values of the recording format; see docs/recording-format.md. Pure. */

export const MAGIC = 'RoboNewbie recording\n';
export const VERSION = 1;

/** Kinds of records. */
export const KIND = {
  HEADER: 1,
  GAME: 2,
  ROBOTS: 3,
  COMMANDS: 4,
  EVENT: 5,
  CYCLE: 6,
  STATE: 7,
  THINGS: 8,
  MOVED_THING: 9,
  MODEL: 10,
};
export const POSE_NUMBERS = 7;
export const STEPS_PER_METRE = 10_000;
export const SIDES = /** @type {const} */ (['', 'left', 'right']);

/** Thrown when the bytes end within a value. */
export class EndOfBytes extends Error {}

/** Sequential reader of bytes. */
export class Source {
  /** @param {Uint8Array} content */
  constructor(content) {
    this.content = content;
    this.at = 0;
  }

  /** @param {number} count */
  bytes(count) {
    if (this.at + count > this.content.length) {
      throw new EndOfBytes();
    }
    this.at += count;
    return this.content.subarray(this.at - count, this.at);
  }

  /** @returns {number} */
  unsigned() {
    let value = 0;
    for (let factor = 1; ; factor *= 128) {
      const byte = this.bytes(1)[0];
      value += (byte & 127) * factor;
      if (byte < 128) {
        return value;
      }
    }
  }

  /** @returns {number} */
  signed() {
    const value = this.unsigned();
    return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
  }

  /** @returns {string} */
  text() {
    return new TextDecoder().decode(this.bytes(this.unsigned()));
  }
}
