/** What programs have commanded, for all robots in one array, since there is one for each cycle of a recording. Pure. */

const MOST_HINGES = 24;

export class CommandedSpeeds {
  /** @param {Map<number, number>} places of the robots in the array, by their ids; common to all cycles @param {Float32Array} values */
  constructor(places = new Map(), values = new Float32Array(0)) {
    this.places = places;
    this.values = values;
  }

  copy() {
    return new CommandedSpeeds(this.places, this.values.slice());
  }

  /** @param {number} id of a robot @returns {Float32Array} its speeds, degrees per second by hinge, to be changed */
  of(id) {
    const place = this.places.get(id) ?? this.places.size;
    this.places.set(id, place);
    const end = (place + 1) * MOST_HINGES;
    if (end > this.values.length) {
      const longer = new Float32Array(end);
      longer.set(this.values);
      this.values = longer;
    }
    return this.values.subarray(end - MOST_HINGES, end);
  }

  /** @param {number} id of a robot @returns {Float32Array | undefined} its speeds, degrees per second by hinge */
  get(id) {
    const begin = (this.places.get(id) ?? Infinity) * MOST_HINGES;
    return begin < this.values.length ? this.values.subarray(begin, begin + MOST_HINGES) : undefined;
  }

  /** How many robots have been commanded so far. */
  get size() {
    return this.values.length / MOST_HINGES;
  }
}
