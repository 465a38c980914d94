/**
 * Moves keyframes in time. A motion says for each keyframe how long the way to it takes, so that all later ones follow if
 * only this way changes; a keyframe that moves alone takes from the next way what its own gains. Pure.
 */
import { CYCLE_MILLIS, wholeCycles } from './motion-document.js';

/**
 * @param {readonly number[]} ways milliseconds to each keyframe from the one before
 * @param {readonly number[]} chosen indices of the keyframes that move, in their order
 * @param {number} by milliseconds, negative for earlier
 * @param {boolean} alone whether all others stay where they are
 * @returns {number[]} the new ways; no keyframe overtakes another
 */
export function retimed(ways, chosen, by, alone) {
  const first = chosen[0];
  if (first === undefined) {
    return [...ways];
  }
  const wish = wholeCycles(Math.max(CYCLE_MILLIS, ways[first] + by)) - ways[first];
  if (!alone) {
    return [...ways].with(first, ways[first] + wish);
  }
  const growing = chosen.filter((index) => !chosen.includes(index - 1));
  const shrinking = chosen.map((index) => index + 1).filter((index) => index < ways.length && !chosen.includes(index));
  const least = Math.max(...growing.map((index) => Math.min(0, CYCLE_MILLIS - ways[index])));
  const most = Math.min(Infinity, ...shrinking.map((index) => Math.max(0, ways[index] - CYCLE_MILLIS)));
  const step = Math.max(least, Math.min(most, wish));
  return ways.map((way, index) => way + (growing.includes(index) ? step : 0) - (shrinking.includes(index) ? step : 0));
}
