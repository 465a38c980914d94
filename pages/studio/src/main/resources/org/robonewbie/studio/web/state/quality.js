/**
 * Chooses how fine the picture is by the time that pictures take, so that weak computers stay smooth. Pure.
 *
 * @typedef {'fine' | 'coarse' | 'tiny'} Detail
 *
 * @typedef {object} Quality
 * @property {string} name
 * @property {number} pixelRatio pixels of the picture per pixel of the page, at most
 * @property {boolean} antialias
 * @property {boolean} glossy whether surfaces shine
 * @property {boolean} smooth whether pictures are drawn also between two frames of the simulation
 * @property {Detail} nearDetail how finely robots are drawn that are near
 * @property {Detail} farDetail how finely the others are drawn
 * @property {number} nearMetres up to where a robot is near
 * @property {number} mostNear how many robots at most are drawn as near ones
 */

/** @type {Quality} */
const LOW = {
  name: 'low',
  pixelRatio: 0.75,
  antialias: false,
  glossy: false,
  smooth: false,
  nearDetail: 'coarse',
  farDetail: 'tiny',
  nearMetres: 4,
  mostNear: 2,
};

/** From cheap to fine. @type {Quality[]} */
export const QUALITIES = [
  { ...LOW, name: 'lowest', pixelRatio: 0.5, mostNear: 1 },
  LOW,
  { ...LOW, name: 'medium', pixelRatio: 1, smooth: true, nearDetail: 'fine', nearMetres: 5, mostNear: 3 },
  {
    name: 'high',
    pixelRatio: 2,
    antialias: true,
    glossy: true,
    smooth: true,
    nearDetail: 'fine',
    farDetail: 'coarse',
    nearMetres: 7,
    mostNear: 22,
  },
];

const PICTURES = 24;
const TOO_SLOW_MILLISECONDS = 45;
const EASY_MILLISECONDS = 21;
const EASY_ROUNDS = 5;

/** After so many easy rounds a quality that was too slow is tried again; each failure doubles them. */
const FORGIVING_ROUNDS = 30;

/**
 * Finds the level by its name in the page's address.
 *
 * @param {string | null} name
 * @returns {number} index, or -1 for an unknown name
 */
export function qualityIndex(name) {
  return QUALITIES.findIndex((quality) => quality.name === name);
}

/**
 * Guesses where to start, and how high it may go.
 *
 * @param {string} graphics what the browser says about the graphics card
 * @returns {{first: number, highest: number}} indices of qualities
 */
export function qualityRange(graphics) {
  const software = /swiftshader|llvmpipe|software|basic render/i.test(graphics);
  const best = QUALITIES.length - 1;
  return software ? { first: 1, highest: best - 1 } : { first: best, highest: best };
}

/** Watches how long pictures take and says when another quality is better. */
export class QualityChooser {
  /**
   * @param {{first: number, highest: number}} range where to start and how high to go
   * @param {boolean} fixed whether the person has chosen and nothing may change
   */
  constructor({ first, highest }, fixed) {
    this.index = first;
    this.highest = highest;
    this.ceiling = highest;
    this.fixed = fixed;
    this.easyRounds = 0;
    this.forgivingRounds = FORGIVING_ROUNDS;
    /** @type {number[]} */
    this.times = [];
  }

  /** @returns {Quality} */
  get quality() {
    return QUALITIES[this.index];
  }

  /**
   * Takes the time after which the browser was ready again when a picture had been drawn.
   *
   * @param {number} milliseconds
   * @returns {boolean} whether the quality has changed
   */
  pictureTook(milliseconds) {
    if (this.fixed) {
      return false;
    }
    this.times.push(milliseconds);
    if (this.times.length < PICTURES) {
      return false;
    }
    const median = this.times.sort((a, b) => a - b)[PICTURES / 2];
    this.times = [];
    return this.#judge(median);
  }

  /** @param {number} median */
  #judge(median) {
    if (median > TOO_SLOW_MILLISECONDS) {
      this.easyRounds = 0;
      return this.index > 0 && this.#lower();
    }
    this.easyRounds = median < EASY_MILLISECONDS ? this.easyRounds + 1 : 0;
    if (this.easyRounds >= this.forgivingRounds) {
      this.ceiling = Math.min(this.highest, this.index + 1);
    }
    return this.easyRounds >= EASY_ROUNDS && this.index < this.ceiling && this.#change(1);
  }

  #lower() {
    this.ceiling = this.index - 1;
    this.forgivingRounds *= 2;
    return this.#change(-1);
  }

  /** @param {number} direction */
  #change(direction) {
    this.index += direction;
    this.easyRounds = 0;
    return true;
  }
}
