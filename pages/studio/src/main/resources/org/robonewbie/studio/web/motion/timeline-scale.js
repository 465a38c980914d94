/** Time scale of the timeline. */
import { shownPart } from '../state/motion/time-view.js';

/**
 * @typedef {object} TimeScale
 * @property {number} width pixels
 * @property {number} from milliseconds at the left
 * @property {number} span visible milliseconds
 * @property {number} perMilli pixels per millisecond
 * @property {(time: number) => number} x position of a time
 * @property {(x: number) => number} time time at a position
 */

/** Margin for half a stick figure at both ends. */
export const SIDE = 24;

/**
 * @param {import('../state/motion/time-view.js').TimeView} view
 * @param {number} length length of the displayable range, milliseconds
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
