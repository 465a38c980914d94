/**
 * Where the eye is: a point that it looks at, two angles and a distance. Pure.
 *
 * @typedef {object} ViewPoint
 * @property {number[]} target the point looked at, metres
 * @property {number} azimuthDegrees direction from the target to the eye, counter-clockwise from the x axis
 * @property {number} elevationDegrees height of the eye over the horizon
 * @property {number} distance metres
 */

const LOWEST_DEGREES = 2;
const HIGHEST_DEGREES = 89.9;
const NEAREST = 0.35;
const FARTHEST = 60;
const RADIANS = Math.PI / 180;

/**
 * @param {ViewPoint} view
 * @param {number} azimuthDegrees
 * @param {number} elevationDegrees
 * @returns {ViewPoint}
 */
export function turned(view, azimuthDegrees, elevationDegrees) {
  return {
    ...view,
    azimuthDegrees: view.azimuthDegrees + azimuthDegrees,
    elevationDegrees: clamp(view.elevationDegrees + elevationDegrees, LOWEST_DEGREES, HIGHEST_DEGREES),
  };
}

/**
 * @param {ViewPoint} view
 * @param {number} factor below 1 goes nearer
 * @returns {ViewPoint}
 */
export function zoomed(view, factor) {
  return { ...view, distance: clamp(view.distance * factor, NEAREST, FARTHEST) };
}

/**
 * Moves the target over the ground.
 *
 * @param {ViewPoint} view
 * @param {number} right part of the distance to the right on the screen
 * @param {number} up part of the distance away from the eye
 * @returns {ViewPoint}
 */
export function moved(view, right, up) {
  const sine = Math.sin(view.azimuthDegrees * RADIANS);
  const cosine = Math.cos(view.azimuthDegrees * RADIANS);
  const [x, y, z] = view.target;
  const target = [
    clamp(x + view.distance * (-sine * right - cosine * up), -30, 30),
    clamp(y + view.distance * (cosine * right - sine * up), -30, 30),
    z,
  ];
  return { ...view, target };
}

/**
 * @param {ViewPoint} view
 * @returns {number[]} position of the eye
 */
export function eye(view) {
  const flat = Math.cos(view.elevationDegrees * RADIANS) * view.distance;
  return [
    view.target[0] + Math.cos(view.azimuthDegrees * RADIANS) * flat,
    view.target[1] + Math.sin(view.azimuthDegrees * RADIANS) * flat,
    view.target[2] + Math.sin(view.elevationDegrees * RADIANS) * view.distance,
  ];
}

/**
 * A view of the whole pitch.
 *
 * @param {{length: number, width: number}} field
 * @param {number} aspect width of the picture divided by its height
 * @param {boolean} fromTop straight down or from the side line
 * @returns {ViewPoint}
 */
export function overview(field, aspect, fromTop) {
  const extent = Math.max((field.length + 1.5) / aspect, field.width + (fromTop ? 1.5 : -1));
  return {
    target: [0, fromTop ? 0 : -0.05 * field.width, 0],
    azimuthDegrees: -90,
    elevationDegrees: fromTop ? HIGHEST_DEGREES : 36,
    distance: extent * 1.5,
  };
}

/**
 * @param {number} value
 * @param {number} least
 * @param {number} most
 */
function clamp(value, least, most) {
  return Math.max(least, Math.min(most, value));
}
