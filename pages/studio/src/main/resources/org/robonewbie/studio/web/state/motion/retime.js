/**
 * Moves keyframes in time. Each keyframe stores the duration of its transition, so changing it shifts all later keyframes; moving a
 * keyframe alone also adjusts the next duration. Pure.
 */
import { CYCLE_MILLIS, wholeCycles } from './motion-document.js';

/**
 * @param {readonly number[]} ways durations of the transitions, milliseconds
 * @param {readonly number[]} chosen ascending indices of the keyframes to move
 * @param {number} by milliseconds, negative for earlier
 * @param {boolean} alone whether all other keyframes keep their times
 * @returns {number[]} the new durations; the order of keyframes is preserved
 */
export function retimed(ways, chosen, by, alone) {
  const first = chosen[0];
  if (first === undefined) {
    return [...ways];
  }
  const requested = wholeCycles(Math.max(CYCLE_MILLIS, ways[first] + by)) - ways[first];
  if (!alone) {
    return [...ways].with(first, ways[first] + requested);
  }
  const growing = chosen.filter((index) => !chosen.includes(index - 1));
  const shrinking = chosen.map((index) => index + 1).filter((index) => index < ways.length && !chosen.includes(index));
  const min = Math.max(...growing.map((index) => Math.min(0, CYCLE_MILLIS - ways[index])));
  const max = Math.min(Infinity, ...shrinking.map((index) => Math.max(0, ways[index] - CYCLE_MILLIS)));
  const step = Math.max(min, Math.min(max, requested));
  return ways.map((way, index) => way + (growing.includes(index) ? step : 0) - (shrinking.includes(index) ? step : 0));
}
