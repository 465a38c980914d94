/** Time series of one robot's values: a table with one row per cycle and one column per name. */
import { csvCell } from '../csv-cell.js';
import { CYCLE_SECONDS } from '../cycle.js';
import { partitionPoint } from '../partition-point.js';

/** Maximum number of rows: five minutes. */
const MAX_ROWS = 15_000;

export class Traces {
  constructor() {
    /** @type {Map<string, number>} column of each name */
    this.names = new Map();
    /** @type {number[]} */
    this.cycles = [];
    /** @type {Array<Array<number | undefined>>} */
    this.rows = [];
    /** Incremented on each change. */
    this.revision = 0;
  }

  /**
   * Adds values to a cycle. Cycles must be added in ascending order, except for a few late ones.
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
    if (this.rows.length > MAX_ROWS * 1.1) {
      this.cycles.splice(0, this.rows.length - MAX_ROWS);
      this.rows.splice(0, this.rows.length - MAX_ROWS);
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

  /** @returns {{from: number, to: number}} time of the first and the last row */
  get extent() {
    return { from: (this.cycles[0] ?? 0) * CYCLE_SECONDS, to: (this.cycles.at(-1) ?? 0) * CYCLE_SECONDS };
  }

  /**
   * @param {string} name
   * @param {number} seconds
   * @returns {number | undefined} the latest value at or before that time
   */
  valueAt(name, seconds) {
    const column = this.names.get(name) ?? -1;
    const end = this.#countBefore(seconds / CYCLE_SECONDS + 0.5);
    return this.rows.slice(Math.max(0, end - 10), end).findLast((row) => row[column] !== undefined)?.[column];
  }

  /** @param {number} cycle */
  #countBefore(cycle) {
    return partitionPoint(this.cycles.length, (i) => this.cycles[i] < cycle);
  }
}

/**
 * Writes values as a CSV table.
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
