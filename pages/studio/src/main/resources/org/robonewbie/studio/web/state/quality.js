/**
 * Adaptive rendering quality: adjusts the quality level to the measured frame time to keep motion smooth on slow computers. Pure.
 *
 * @typedef {'fine' | 'coarse' | 'tiny'} Detail
 *
 * @typedef {object} Quality
 * @property {string} name
 * @property {number} pixelRatio maximum number of rendered pixels per page pixel
 * @property {boolean} glossy whether surfaces have reflections
 * @property {boolean} shadows whether the sun casts shadows, unless set by the user
 * @property {boolean} smooth whether pictures are interpolated between two frames of the simulation
 * @property {Detail} nearDetail level of detail of nearby robots
 * @property {Detail} farDetail level of detail of the others
 * @property {number} nearMetres maximum distance of nearby robots
 * @property {number} maxNear maximum number of nearby robots
 */

/** @type {Quality} */
const LOW = {
  name: 'low',
  pixelRatio: 0.75,
  glossy: false,
  shadows: false,
  smooth: false,
  nearDetail: 'coarse',
  farDetail: 'tiny',
  nearMetres: 4,
  maxNear: 2,
};

/** @type {Quality} */
const HIGH = {
  name: 'high',
  pixelRatio: 2,
  glossy: true,
  shadows: false,
  smooth: true,
  nearDetail: 'fine',
  farDetail: 'coarse',
  nearMetres: 7,
  maxNear: 22,
};

/** Quality levels in ascending order. @type {Quality[]} */
export const QUALITIES = [
  { ...LOW, name: 'lowest', pixelRatio: 0.5, maxNear: 1 },
  LOW,
  { ...LOW, name: 'medium', pixelRatio: 1, smooth: true, nearDetail: 'fine', nearMetres: 5, maxNear: 3 },
  HIGH,
  { ...HIGH, name: 'highest', shadows: true },
];

const PICTURES = 24;
const TOO_SLOW_MILLISECONDS = 45;
const EASY_MILLISECONDS = 21;
const EASY_ROUNDS = 5;

/** Number of consecutive fast rounds after which a level that was too slow is tried again; doubled after each failure. */
const FORGIVING_ROUNDS = 30;

/**
 * Finds a level by its name in the page's address.
 *
 * @param {string | null} name
 * @returns {number} index, or -1 for an unknown name
 */
export function qualityIndex(name) {
  return QUALITIES.findIndex((quality) => quality.name === name);
}

/**
 * Estimates the initial and the highest level.
 *
 * @param {string} graphics the browser's description of the graphics card
 * @returns {{first: number, highest: number}} indices of qualities
 */
export function qualityRange(graphics) {
  const software = /swiftshader|llvmpipe|software|basic render/i.test(graphics);
  const [first, highest] = software ? ['low', 'medium'] : ['high', 'highest'];
  return { first: qualityIndex(first), highest: qualityIndex(highest) };
}

/** Measures frame times and changes the level when appropriate. */
export class QualityChooser {
  /**
   * @param {{first: number, highest: number}} range initial and highest level
   * @param {boolean} fixed whether the user has chosen a fixed level
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
   * Records how long the browser took to render a picture and become ready again.
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
