/** The values of one robot over time, to be plotted: a table with one row for each cycle and one column for each name. */
import { csvCell } from '../csv-cell.js';
import { CYCLE_SECONDS } from '../cycle.js';

/** The last five minutes. */
const MOST_ROWS = 15_000;

export class Traces {
  constructor() {
    /** @type {Map<string, number>} column of each name */
    this.names = new Map();
    /** @type {number[]} */
    this.cycles = [];
    /** @type {Array<Array<number | undefined>>} */
    this.rows = [];
    /** Grows with each change. */
    this.revision = 0;
  }

  /**
   * Adds values of a cycle to what is known of it. Cycles come in ascending order, a few may come late.
   *
   * @param {number} cycle
   * @param {Iterable<readonly [string, number]>} values
   */
  add(cycle, values) {
    const row = this.#row(cycle);
    for (const [name, value] of values) {
      let column = this.names.get(name);
      if (column === undefined) {
        column = this.names.size;
        this.names.set(name, column);
      }
      row[column] = value;
    }
    this.revision++;
  }

  /** @param {number} cycle */
  #row(cycle) {
    let at = this.cycles.length;
    while (at > 0 && this.cycles[at - 1] > cycle) {
      at--;
    }
    if (at > 0 && this.cycles[at - 1] === cycle) {
      return this.rows[at - 1];
    }
    /** @type {Array<number | undefined>} */
    const row = [];
    this.cycles.splice(at, 0, cycle);
    this.rows.splice(at, 0, row);
    if (this.rows.length > MOST_ROWS * 1.1) {
      this.cycles.splice(0, this.rows.length - MOST_ROWS);
      this.rows.splice(0, this.rows.length - MOST_ROWS);
    }
    return row;
  }

  /**
   * @param {readonly string[]} names
   * @param {number} from seconds
   * @param {number} to seconds
   * @returns {Array<Array<number | null>>} seconds, then the values of each name
   */
  columns(names, from, to) {
    const first = Math.max(0, this.#countBefore(from / CYCLE_SECONDS) - 1);
    const last = Math.min(this.rows.length, this.#countBefore(to / CYCLE_SECONDS) + 1);
    const rows = this.rows.slice(first, last);
    const seconds = this.cycles.slice(first, last).map((cycle) => cycle * CYCLE_SECONDS);
    return [
      seconds,
      ...names.map((name) => {
        const column = this.names.get(name) ?? -1;
        return rows.map((row) => row[column] ?? null);
      }),
    ];
  }

  /** @returns {{from: number, to: number}} seconds of the first and last row */
  get extent() {
    return { from: (this.cycles[0] ?? 0) * CYCLE_SECONDS, to: (this.cycles.at(-1) ?? 0) * CYCLE_SECONDS };
  }

  /**
   * @param {string} name
   * @param {number} seconds
   * @returns {number | undefined} the last value that is not later
   */
  valueAt(name, seconds) {
    const column = this.names.get(name) ?? -1;
    const end = this.#countBefore(seconds / CYCLE_SECONDS + 0.5);
    return this.rows.slice(Math.max(0, end - 10), end).findLast((row) => row[column] !== undefined)?.[column];
  }

  /** @param {number} cycle */
  #countBefore(cycle) {
    let [low, high] = [0, this.cycles.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.cycles[middle] < cycle) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }
}

/**
 * Writes values as a table for other programs.
 *
 * @param {Traces} traces
 * @param {readonly string[]} names
 * @param {number} from seconds
 * @param {number} to seconds
 * @returns {string}
 */
export function tableOf(traces, names, from, to) {
  const columns = traces.columns(names, from, to);
  const head = ['seconds', ...names].map(csvCell);
  const rows = columns[0].map((seconds, i) =>
    [(seconds ?? 0).toFixed(2), ...columns.slice(1).map((column) => column[i] ?? '')].join(','),
  );
  return [head.join(','), ...rows, ''].join('\n');
}
