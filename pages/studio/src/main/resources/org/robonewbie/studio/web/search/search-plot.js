/** Plots of values over the rounds of a search. */
import { axes, roomy, uPlot } from '../robot/plotter.js';

/**
 * @typedef {object} Curve
 * @property {string} label
 * @property {string} colour name of a theme colour
 * @property {number[]} [dash]
 * @property {boolean} [points] whether each value is marked
 */

/**
 * Creates an empty plot that fills its container.
 *
 * @param {HTMLElement} place
 * @param {readonly Curve[]} curves
 */
export function searchPlot(place, curves) {
  const style = getComputedStyle(place);
  const colour = (/** @type {string} */ name) => style.getPropertyValue(name).trim();
  const size = () => ({ width: Math.max(60, place.clientWidth), height: Math.max(60, place.clientHeight) });
  const [rounds, values] = axes(colour);
  const series = curves.map(({ label, colour: name, dash, points }) => ({
    label,
    dash,
    stroke: () => colour(name),
    width: 2,
    points: { show: points ?? false, size: 4 },
  }));
  const plot = new (uPlot())(
    {
      ...size(),
      legend: { show: false },
      cursor: { drag: { x: false, y: false }, points: { size: 7 }, sync: { key: 'search' } },
      scales: { x: { time: false, range: wholeRounds }, y: { range: roomy } },
      axes: [{ ...rounds, incrs: WHOLE_STEPS }, values],
      series: [{}, ...series],
    },
    [[], ...curves.map(() => [])],
    place,
  );
  new ResizeObserver(() => plot.setSize(size())).observe(place);
  return plot;
}

/** Tick spacings, in whole rounds. */
const WHOLE_STEPS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000];

/**
 * Returns the range of the horizontal axis, with space for a single round.
 *
 * @param {any} _ @param {number | null} min @param {number | null} max
 */
function wholeRounds(_, min, max) {
  return [Math.min(1, min ?? 1), Math.max(2, max ?? 2)];
}
