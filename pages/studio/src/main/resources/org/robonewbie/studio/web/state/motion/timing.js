/**
 * Timing of a motion: the robot moves each joint linearly from one keyframe to the next. Pure.
 *
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 */

/**
 * @param {readonly Keyframe[]} frames
 * @returns {number[]} times at which the keyframes are reached, milliseconds
 */
export function timesOf(frames) {
  let time = 0;
  return frames.map(({ millis }) => (time += Math.max(0, millis)));
}

/** @param {readonly Keyframe[]} frames */
export function durationOf(frames) {
  return timesOf(frames).at(-1) ?? 0;
}

/**
 * @param {readonly Keyframe[]} frames
 * @param {readonly number[]} start the posture before the motion
 * @param {number} time milliseconds
 * @returns {readonly number[]} 22 angles
 */
export function postureAt(frames, start, time) {
  const times = timesOf(frames);
  const next = times.findIndex((each) => time < each);
  if (next < 0) {
    return frames.at(-1)?.degrees ?? start;
  }
  const from = next === 0 ? start : frames[next - 1].degrees;
  const part = Math.max(0, (time - (times[next - 1] ?? 0)) / frames[next].millis);
  return from.map((angle, i) => angle + part * (frames[next].degrees[i] - angle));
}

/**
 * @param {readonly Keyframe[]} frames
 * @param {number} time
 * @returns {number} index of the next keyframe, or of the last one after the end; -1 if there are no keyframes
 */
export function keyframeAt(frames, time) {
  const next = timesOf(frames).findIndex((each) => time <= each + 0.5);
  return next < 0 ? frames.length - 1 : next;
}

/** @param {number} millis @returns {string} formatted seconds */
export function secondsText(millis) {
  return `${(millis / 1000).toFixed(2)} s`;
}
