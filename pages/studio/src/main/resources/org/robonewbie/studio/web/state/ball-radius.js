/** Radius of SimSpark's ball in metres. */
export const BALL_RADIUS = 0.042;

/** @param {import('../live/state-frame.js').Scene | undefined} scene @returns {number} radius of the scene's ball, metres */
export const ballRadiusOf = (scene) => scene?.details?.ballRadius ?? BALL_RADIUS;
