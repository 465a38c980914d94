/**
 * What one robot has told, heard and been told over time, so that each moment of the last minutes can be looked at again.
 *
 * @typedef {import('./telemetry.js').LogLine} LogLine
 * @typedef {import('./telemetry.js').Belief} Belief
 * @typedef {import('./telemetry.js').Drawing} Drawing
 * @typedef {import('./telemetry.js').MotionProgress} MotionProgress
 *
 * @typedef {object} Exchange
 * @property {number} seconds
 * @property {string} perceptors message of the simulator
 * @property {string} effectors message of the agent
 *
 * @typedef {object} Thoughts what is known of one moment
 * @property {readonly LogLine[]} log all lines, also later ones
 * @property {MotionProgress} motion
 * @property {Belief | undefined} belief
 * @property {readonly Drawing[]} drawings
 * @property {Exchange | undefined} exchange
 * @property {Exchange | undefined} picture the last exchange in which the camera has told what it sees
 */
import { readTelemetry } from './telemetry.js';

const MOST_LINES = 5000;
const MOST_MOMENTS = 15_000;
const BELIEF_SECONDS = 5;
const MESSAGE_SECONDS = 0.5;
const PICTURE_MESSAGES = 12;
const HALF_CYCLE = 0.01;

/** How long a picture that an agent has drawn stays if it draws no other. */
export const DRAWING_SECONDS = 1;

export class RobotMemory {
  constructor() {
    /** @type {LogLine[]} */
    this.log = [];
    /** @type {Array<{seconds: number, motion: MotionProgress}>} */
    this.motions = [];
    /** @type {Array<{seconds: number, belief: Belief}>} */
    this.beliefs = [];
    /** @type {Array<{seconds: number, drawings: Drawing[]}>} */
    this.pictures = [];
    /** @type {Exchange[]} */
    this.exchanges = [];
  }

  /**
   * @param {string} line of telemetry
   * @returns {{name: string, value: number, seconds: number} | undefined} a value to be plotted
   */
  hear(line) {
    const told = readTelemetry(line);
    if (told.kind === 'log') {
      keep(this.log, told.log, MOST_LINES);
    } else if (told.kind === 'motion') {
      keep(this.motions, told, MOST_LINES);
    } else if (told.kind === 'belief') {
      keep(this.beliefs, told, MOST_MOMENTS);
    } else if (told.kind === 'draw') {
      keep(this.pictures, told, MOST_MOMENTS);
    }
    return told.kind === 'plot' ? told : undefined;
  }

  /** @param {Exchange} exchange */
  exchanged(exchange) {
    keep(this.exchanges, exchange, MOST_MOMENTS);
  }

  /** @param {number} seconds @returns {Thoughts} */
  at(seconds) {
    const young = (/** @type {{seconds: number} | undefined} */ each, /** @type {number} */ limit) =>
      each !== undefined && seconds - each.seconds < limit;
    const belief = latest(this.beliefs, seconds);
    const picture = latest(this.pictures, seconds);
    const exchange = latest(this.exchanges, seconds);
    return {
      log: this.log,
      motion: latest(this.motions, seconds)?.motion ?? { name: '', keyframe: 0 },
      belief: young(belief, BELIEF_SECONDS) ? belief?.belief : undefined,
      drawings: young(picture, DRAWING_SECONDS) ? (picture?.drawings ?? []) : [],
      exchange: young(exchange, MESSAGE_SECONDS) ? exchange : undefined,
      picture: this.#picture(seconds),
    };
  }

  /** @param {number} seconds */
  #picture(seconds) {
    const end = countUntil(this.exchanges, seconds);
    return this.exchanges
      .slice(Math.max(0, end - PICTURE_MESSAGES), end)
      .findLast(({ perceptors, seconds: then }) => perceptors.includes('(See') && seconds - then < MESSAGE_SECONDS);
  }
}

/**
 * Adds something, and forgets the oldest if there is too much.
 *
 * @template {{seconds: number}} T
 * @param {T[]} list
 * @param {T} item
 * @param {number} most
 */
export function keep(list, item, most) {
  list.push(item);
  if (list.length > most * 1.1) {
    list.splice(0, list.length - most);
  }
}

/** @param {ReadonlyArray<{seconds: number}>} list @param {number} seconds @returns {number} how many are not later */
function countUntil(list, seconds) {
  let [low, high] = [0, list.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (list[middle].seconds <= seconds + HALF_CYCLE) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

/** @template {{seconds: number}} T @param {T[]} list @param {number} seconds @returns {T | undefined} */
export function latest(list, seconds) {
  return list[countUntil(list, seconds) - 1];
}
