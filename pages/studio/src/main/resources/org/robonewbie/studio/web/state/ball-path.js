/** Where the ball was in the last seconds. Pure. */
import { CYCLE_SECONDS } from './cycle.js';

/** How long the trail is. */
export const TRAIL_SECONDS = 3;

const LEAST_METRES = 0.03;
const LONGEST_GAP_SECONDS = 0.5;

/** Faster than any kick: the ball was put elsewhere. */
const LEAP_METRES_PER_SECOND = 25;

export class BallPath {
  /** The oldest place first. @type {Array<{seconds: number, place: number[]}>} */
  #places = [];
  #now = 0;

  clear() {
    this.#places = [];
  }

  /** @param {number} cycle @param {ArrayLike<number>} ball its pose */
  add(cycle, ball) {
    const seconds = cycle * CYCLE_SECONDS;
    const place = [ball[0], ball[1], ball[2]];
    const last = this.#places.at(-1);
    const passed = seconds - this.#now;
    if (passed < 0 || passed > LONGEST_GAP_SECONDS || (last && distance(last.place, place) > leap(passed))) {
      this.clear();
    }
    this.#now = seconds;
    if (!this.#places.length || distance(/** @type {any} */ (this.#places.at(-1)).place, place) >= LEAST_METRES) {
      this.#places.push({ seconds, place });
    }
    while (this.#places.length > 1 && this.#places[0].seconds < seconds - TRAIL_SECONDS) {
      this.#places.shift();
    }
  }

  /** @returns {Array<{place: number[], freshness: number}>} places and how fresh they are, from 0 to 1; none while the ball lies */
  get trail() {
    const places = this.#places.map(({ seconds, place }) => ({
      place,
      freshness: Math.max(0, 1 - (this.#now - seconds) / TRAIL_SECONDS),
    }));
    return places.length > 1 ? places : [];
  }
}

/** @param {number[]} a @param {number[]} b */
function distance(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** @param {number} seconds */
function leap(seconds) {
  return LEAST_METRES * 3 + LEAP_METRES_PER_SECOND * seconds;
}
