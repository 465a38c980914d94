/** Recent positions of the ball. Pure. */
import { CYCLE_SECONDS } from './cycle.js';

/** Length of the trail. */
export const TRAIL_SECONDS = 3;

const MIN_METRES = 0.03;
const MAX_GAP_SECONDS = 0.5;

/** Speed above which the ball must have been repositioned; no kick is that fast. */
const LEAP_METRES_PER_SECOND = 25;

export class BallPath {
  /** Positions in chronological order. @type {Array<{seconds: number, place: number[]}>} */
  #places = [];
  #now = 0;

  clear() {
    this.#places = [];
  }

  /** @param {number} cycle @param {ArrayLike<number>} ball pose */
  add(cycle, ball) {
    const seconds = cycle * CYCLE_SECONDS;
    const place = [ball[0], ball[1], ball[2]];
    const last = this.#places.at(-1);
    const passed = seconds - this.#now;
    if (passed < 0 || passed > MAX_GAP_SECONDS || (last && distance(last.place, place) > leap(passed))) {
      this.clear();
    }
    this.#now = seconds;
    if (!this.#places.length || distance(/** @type {any} */ (this.#places.at(-1)).place, place) >= MIN_METRES) {
      this.#places.push({ seconds, place });
    }
    while (this.#places.length > 1 && this.#places[0].seconds < seconds - TRAIL_SECONDS) {
      this.#places.shift();
    }
  }

  /** @returns {Array<{place: number[], freshness: number}>} positions with their freshness, from 0 to 1; empty while the ball is at rest */
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
  return MIN_METRES * 3 + LEAP_METRES_PER_SECOND * seconds;
}
