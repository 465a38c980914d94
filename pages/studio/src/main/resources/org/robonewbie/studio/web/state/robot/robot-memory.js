/**
 * Telemetry and messages of one robot over time, for looking back at the last few minutes.
 *
 * @typedef {import('./telemetry.js').LogLine} LogLine
 * @typedef {import('./telemetry.js').Belief} Belief
 * @typedef {import('./telemetry.js').Drawing} Drawing
 * @typedef {import('./telemetry.js').MotionProgress} MotionProgress
 *
 * @typedef {object} Exchange
 * @property {number} seconds
 * @property {string} perceptors message from the simulator
 * @property {string} effectors message from the agent
 *
 * @typedef {object} Thoughts telemetry at one moment
 * @property {readonly LogLine[]} log all lines, including later ones
 * @property {MotionProgress} motion
 * @property {Belief | undefined} belief
 * @property {readonly Drawing[]} drawings
 * @property {Exchange | undefined} exchange
 * @property {Exchange | undefined} picture the last exchange with camera data
 */
import { partitionPoint } from '../partition-point.js';
import { readTelemetry } from './telemetry.js';

const MAX_LINES = 5000;
const MAX_MOMENTS = 15_000;
const BELIEF_SECONDS = 5;
const MESSAGE_SECONDS = 0.5;
const PICTURE_MESSAGES = 12;
const HALF_CYCLE = 0.01;

/** Time in seconds for which drawings stay visible if no others follow. */
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
   * @param {string} line line of telemetry
   * @returns {{name: string, value: number, seconds: number} | undefined} a value to plot
   */
  receive(line) {
    const item = readTelemetry(line);
    if (item.kind === 'log') {
      keep(this.log, item.log, MAX_LINES);
    } else if (item.kind === 'motion') {
      keep(this.motions, item, MAX_LINES);
    } else if (item.kind === 'belief') {
      keep(this.beliefs, item, MAX_MOMENTS);
    } else if (item.kind === 'draw') {
      keep(this.pictures, item, MAX_MOMENTS);
    }
    return item.kind === 'plot' ? item : undefined;
  }

  /** @param {Exchange} exchange */
  exchanged(exchange) {
    keep(this.exchanges, exchange, MAX_MOMENTS);
  }

  /** @param {number} seconds @returns {Thoughts} */
  at(seconds) {
    const isRecent = (/** @type {{seconds: number} | undefined} */ each, /** @type {number} */ limit) =>
      each !== undefined && seconds - each.seconds < limit;
    const belief = latest(this.beliefs, seconds);
    const picture = latest(this.pictures, seconds);
    const exchange = latest(this.exchanges, seconds);
    return {
      log: this.log,
      motion: latest(this.motions, seconds)?.motion ?? { name: '', keyframe: 0 },
      belief: isRecent(belief, BELIEF_SECONDS) ? belief?.belief : undefined,
      drawings: isRecent(picture, DRAWING_SECONDS) ? (picture?.drawings ?? []) : [],
      exchange: isRecent(exchange, MESSAGE_SECONDS) ? exchange : undefined,
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
 * Appends an item, and removes the oldest ones beyond the limit.
 *
 * @template {{seconds: number}} T
 * @param {T[]} list
 * @param {T} item
 * @param {number} max
 */
export function keep(list, item, max) {
  list.push(item);
  if (list.length > max * 1.1) {
    list.splice(0, list.length - max);
  }
}

/** @param {ReadonlyArray<{seconds: number}>} list @param {number} seconds @returns {number} number of entries that are not later */
function countUntil(list, seconds) {
  return partitionPoint(list.length, (i) => list[i].seconds <= seconds + HALF_CYCLE);
}

/** @template {{seconds: number}} T @param {T[]} list @param {number} seconds @returns {T | undefined} */
export function latest(list, seconds) {
  return list[countUntil(list, seconds) - 1];
}
