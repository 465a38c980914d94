/**
 * Which part of a motion the timeline shows: it can be zoomed and scrolled. Pure.
 *
 * @typedef {object} TimeView
 * @property {number} from milliseconds at the left edge
 * @property {number} span milliseconds from edge to edge, 0 for the whole motion
 */

const LEAST_SPAN = 200;
const SHORTEST = 400;
const BORDER = 0.1;

/** Shows everything, however long the motion becomes. @type {TimeView} */
export const WHOLE = { from: 0, span: 0 };

/**
 * @param {TimeView} view
 * @param {number} length of the motion, milliseconds
 * @returns {TimeView} what is shown of it, with a span
 */
export function shownPart(view, length) {
  const whole = Math.max(length, SHORTEST);
  const span = view.span === 0 ? whole : Math.min(view.span, whole);
  return { from: Math.max(0, Math.min(whole - span, view.from)), span };
}

/**
 * @param {TimeView} view
 * @param {number} length of the motion, milliseconds
 * @param {number} factor below 1 shows less, more closely
 * @param {number} at the time that stays where it is
 * @returns {TimeView}
 */
export function zoomed(view, length, factor, at) {
  const { from, span } = shownPart(view, length);
  const next = Math.max(LEAST_SPAN, span * factor);
  if (next >= Math.max(length, SHORTEST)) {
    return WHOLE;
  }
  return shownPart({ from: at - ((at - from) * next) / span, span: next }, length);
}

/**
 * @param {TimeView} view
 * @param {number} length of the motion, milliseconds
 * @param {number} share of what is shown, negative to the left
 * @returns {TimeView}
 */
export function scrolled(view, length, share) {
  const { from, span } = shownPart(view, length);
  return view.span === 0 ? view : shownPart({ from: from + share * span, span }, length);
}

/**
 * Scrolls so far that a moment can be seen, if it cannot.
 *
 * @param {TimeView} view
 * @param {number} length of the motion, milliseconds
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
