/** Commanded speeds of all robots in one recorded cycle, packed into one array to save memory. Pure. */

const MAX_HINGES = 24;

export class CommandedSpeeds {
  /** @param {Map<number, number>} places offsets of the robots in the array by id, shared by all cycles @param {Float32Array} values */
  constructor(places = new Map(), values = new Float32Array(0)) {
    this.places = places;
    this.values = values;
  }

  copy() {
    return new CommandedSpeeds(this.places, this.values.slice());
  }

  /** @param {number} id ID of a robot @returns {Float32Array} its mutable speeds, degrees per second by hinge */
  of(id) {
    const place = this.places.get(id) ?? this.places.size;
    this.places.set(id, place);
    const end = (place + 1) * MAX_HINGES;
    if (end > this.values.length) {
      const longer = new Float32Array(end);
      longer.set(this.values);
      this.values = longer;
    }
    return this.values.subarray(end - MAX_HINGES, end);
  }

  /** @param {number} id ID of a robot @returns {Float32Array | undefined} its speeds, degrees per second by hinge */
  get(id) {
    const begin = (this.places.get(id) ?? Infinity) * MAX_HINGES;
    return begin < this.values.length ? this.values.subarray(begin, begin + MAX_HINGES) : undefined;
  }

  /** Number of robots that have been commanded so far. */
  get size() {
    return this.values.length / MAX_HINGES;
  }
}
