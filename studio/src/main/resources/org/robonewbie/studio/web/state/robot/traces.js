/**
 * The last seconds of values that change, to be plotted. Pure.
 *
 * @typedef {object} Trace
 * @property {string} name
 * @property {string} unit
 * @property {Array<[number, number]>} points seconds and value, the newest last
 */

const KEPT_SECONDS = 20;

/**
 * Adds the newest values; names that are new begin a trace.
 *
 * @param {readonly Trace[]} traces
 * @param {number} seconds
 * @param {ReadonlyArray<{name: string, unit: string, value: number}>} values
 * @returns {Trace[]}
 */
export function grown(traces, seconds, values) {
  return values.map(({ name, unit, value }) => {
    const before = traces.find((trace) => trace.name === name)?.points ?? [];
    const last = before.at(-1);
    if (last && last[0] === seconds) {
      return { name, unit, points: before };
    }
    const isBack = last !== undefined && seconds < last[0];
    const kept = isBack ? [] : before.filter(([time]) => time > seconds - KEPT_SECONDS);
    return { name, unit, points: [...kept, /** @type {[number, number]} */ ([seconds, value])] };
  });
}

/**
 * @param {readonly Trace[]} traces
 * @returns {{from: number, to: number, least: number, most: number}} what a plot of them must show
 */
export function extentOf(traces) {
  const points = traces.flatMap((trace) => trace.points);
  const to = Math.max(0, ...points.map(([time]) => time));
  const values = points.map(([, value]) => value);
  const least = Math.min(...values, Infinity);
  const most = Math.max(...values, -Infinity);
  const room = Math.max(1, (most - least) * 0.08);
  return { from: Math.max(0, to - KEPT_SECONDS), to: Math.max(to, 1), least: least - room, most: most + room };
}

/**
 * @param {Trace} trace
 * @param {number} seconds
 * @returns {number | undefined} the value at a moment
 */
export function valueAt(trace, seconds) {
  return trace.points.findLast(([time]) => time <= seconds + 1e-6)?.[1];
}
