/** Where moments are on the timeline. */
import { shownPart } from '../state/motion/time-view.js';

/**
 * @typedef {object} TimeScale
 * @property {number} width pixels
 * @property {number} from milliseconds at the left
 * @property {number} span milliseconds that are shown
 * @property {number} perMilli pixels for each millisecond
 * @property {(time: number) => number} x the place of a moment
 * @property {(x: number) => number} time the moment at a place
 */

/** Room for half a figure at both ends. */
export const SIDE = 24;

/**
 * @param {import('../state/motion/time-view.js').TimeView} view
 * @param {number} length of what can be shown, milliseconds
 * @param {number} width pixels
 * @returns {TimeScale}
 */
export function timeScale(view, length, width) {
  const { from, span } = shownPart(view, length);
  const perMilli = Math.max(1, width - 2 * SIDE) / span;
  return {
    width,
    from,
    span,
    perMilli,
    x: (time) => SIDE + (time - from) * perMilli,
    time: (x) => from + (x - SIDE) / perMilli,
  };
}
