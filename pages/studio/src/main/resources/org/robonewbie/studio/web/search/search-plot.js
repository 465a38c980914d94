/** Curves over the rounds of a search. */
import { axes, roomy, uPlot } from '../robot/plotter.js';

/**
 * @typedef {object} Curve
 * @property {string} label
 * @property {string} colour name of a colour of the theme
 * @property {number[]} [dash]
 * @property {boolean} [points] whether each value is marked
 */

/**
 * Makes an empty plot that fills its place.
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

/** Between two rounds there is nothing to mark. */
const WHOLE_STEPS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000];

/** Also a single round has room. @param {any} _ @param {number | null} least @param {number | null} most */
function wholeRounds(_, least, most) {
  return [Math.min(1, least ?? 1), Math.max(2, most ?? 2)];
}
