/**
 * Zoom and scroll position of the timeline. Pure.
 *
 * @typedef {object} TimeView
 * @property {number} from milliseconds at the left edge
 * @property {number} span milliseconds from edge to edge, 0 for the whole motion
 */

const MIN_SPAN = 200;
const SHORTEST = 400;
const BORDER = 0.1;

/** Shows the whole motion, whatever its length. @type {TimeView} */
export const WHOLE = { from: 0, span: 0 };

/**
 * @param {TimeView} view
 * @param {number} length length of the motion, milliseconds
 * @returns {TimeView} the visible range, with a non-zero span
 */
export function shownPart(view, length) {
  const whole = Math.max(length, SHORTEST);
  const span = view.span === 0 ? whole : Math.min(view.span, whole);
  return { from: Math.max(0, Math.min(whole - span, view.from)), span };
}

/**
 * @param {TimeView} view
 * @param {number} length length of the motion, milliseconds
 * @param {number} factor zoom factor; below 1 zooms in
 * @param {number} at the time whose position stays fixed
 * @returns {TimeView}
 */
export function zoomed(view, length, factor, at) {
  const { from, span } = shownPart(view, length);
  const next = Math.max(MIN_SPAN, span * factor);
  if (next >= Math.max(length, SHORTEST)) {
    return WHOLE;
  }
  return shownPart({ from: at - ((at - from) * next) / span, span: next }, length);
}

/**
 * @param {TimeView} view
 * @param {number} length length of the motion, milliseconds
 * @param {number} share fraction of the visible range, negative to the left
 * @returns {TimeView}
 */
export function scrolled(view, length, share) {
  const { from, span } = shownPart(view, length);
  return view.span === 0 ? view : shownPart({ from: from + share * span, span }, length);
}

/**
 * Scrolls to make a time visible, if it is not.
 *
 * @param {TimeView} view
 * @param {number} length length of the motion, milliseconds
 * @param {number} time milliseconds
 * @returns {TimeView}
 */
export function revealing(view, length, time) {
  const { from, span } = shownPart(view, length);
  if (view.span === 0 || (time >= from && time <= from + span)) {
    return view;
  }
  const border = BORDER * span;
  return shownPart({ from: time < from ? time - border : time - span + border, span }, length);
}
