/** The decompressed bytes of a recording. */

const FIRST_BYTES = 1 << 16;
const MAX_BYTES = 400_000_000;

export class OpenRecording {
  #bytes = new Uint8Array(FIRST_BYTES);
  length = 0;
  /** Number of bytes that the replay service has read. */
  read = 0;
  /** Logs and drawings of the robots, one JSON object per line. */
  notes = '';

  /** @param {Uint8Array} bytes next bytes */
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
}
