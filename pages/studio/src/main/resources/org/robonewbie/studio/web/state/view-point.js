/**
 * Camera position in spherical coordinates around a target. Pure.
 *
 * @typedef {object} ViewPoint
 * @property {number[]} target target point, metres
 * @property {number} azimuthDegrees direction from the target to the camera, counter-clockwise from the x axis
 * @property {number} elevationDegrees angle of the camera above the horizon
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
 * @param {number} factor zoom factor; below 1 zooms in
 * @returns {ViewPoint}
 */
export function zoomed(view, factor) {
  return { ...view, distance: clamp(view.distance * factor, NEAREST, FARTHEST) };
}

/**
 * Moves the target on the ground.
 *
 * @param {ViewPoint} view
 * @param {number} right fraction of the camera's distance to the target, to the right on the screen
 * @param {number} up fraction of the same distance, away from the camera
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
 * @returns {number[]} position of the camera
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
 * Zooms towards a point, which keeps its position on the screen.
 *
 * @param {ViewPoint} view
 * @param {number} factor zoom factor; below 1 zooms in
 * @param {number[]} point
 * @returns {ViewPoint}
 */
export function zoomedTo(view, factor, point) {
  const near = zoomed(view, factor);
  const part = near.distance / view.distance;
  return { ...near, target: view.target.map((value, i) => point[i] + part * (value - point[i])) };
}

/**
 * Angle of view of the area not covered by panels.
 *
 * @typedef {object} FreeView
 * @property {number} across tangent of the angle from its centre to its sides
 * @property {number} up tangent of the angle from its centre to its upper edge
 */

/**
 * Moves the camera as near as possible while all points stay visible.
 *
 * @param {ViewPoint} view
 * @param {readonly number[][]} points
 * @param {FreeView} free
 * @returns {ViewPoint}
 */
export function fitted(view, points, free) {
  const distances = points.map((point) => {
    const { right, up, near } = seenFrom(view, point);
    return Math.max(Math.abs(right) / free.across, Math.abs(up) / free.up) + near;
  });
  return { ...view, distance: clamp(Math.max(...distances), NEAREST, FARTHEST) };
}

/**
 * Returns a point in the camera frame, relative to the target: right, up, and towards the camera.
 *
 * @param {ViewPoint} view
 * @param {readonly number[]} point
 */
function seenFrom({ target, azimuthDegrees, elevationDegrees }, point) {
  const [sine, cosine] = [Math.sin(azimuthDegrees * RADIANS), Math.cos(azimuthDegrees * RADIANS)];
  const [high, flat] = [Math.sin(elevationDegrees * RADIANS), Math.cos(elevationDegrees * RADIANS)];
  const [x, y, z] = point.map((value, i) => value - target[i]);
  const outward = cosine * x + sine * y;
  return { right: cosine * y - sine * x, up: flat * z - high * outward, near: flat * outward + high * z };
}

/**
 * Returns a view of the whole pitch with both goals.
 *
 * @param {{length: number, width: number}} field
 * @param {FreeView} free
 * @param {boolean} fromTop whether to look straight down rather than from the touchline
 * @returns {ViewPoint}
 */
export function overview(field, free, fromTop) {
  const [x, y] = [field.length / 2 + 0.8, field.width / 2 + 0.3];
  const view = {
    target: [0, fromTop ? 0 : -0.1 * field.width, 0],
    azimuthDegrees: -90,
    elevationDegrees: fromTop ? HIGHEST_DEGREES : 36,
    distance: FARTHEST,
  };
  return fitted(
    view,
    [-x, x].flatMap((end) => [-y, y].map((side) => [end, side, 0])),
    free,
  );
}

const OPENING_SLANTS = [-36, -28, -18, 18, 28, 36];
const OPENING_ELEVATIONS = [12, 18, 26];
const OPENING_DISTANCES = [2.1, 9];
const ROBOT_REACH = 0.3;

/**
 * Returns an over-the-shoulder view of a robot, with the ball and the goal that it attacks.
 *
 * @param {number[]} target centre of the robot
 * @param {number[]} ball
 * @param {number[]} goal centre of the goal line
 * @param {FreeView} free
 * @returns {ViewPoint} the nearest such view
 */
export function openingShot(target, ball, goal, free) {
  const [x, y] = target;
  const [side, top] = [1.1, 0.8];
  const points = [[x, y, 0], [x, y, 0.6], ball, [goal[0], goal[1] - side, top], [goal[0], goal[1] + side, top]];
  const behind = Math.atan2(y - goal[1], x - goal[0]) / RADIANS;
  const views = OPENING_SLANTS.flatMap((slant) =>
    OPENING_ELEVATIONS.map((elevationDegrees) =>
      fitted({ target, azimuthDegrees: behind + slant, elevationDegrees, distance: FARTHEST }, points, free),
    ),
  );
  const clear = views.filter((view) => {
    const { right, near } = seenFrom(view, ball);
    return Math.abs(right) > (ROBOT_REACH * (view.distance - near)) / view.distance;
  });
  const best = (clear.length > 0 ? clear : views).reduce((nearest, view) =>
    view.distance < nearest.distance ? view : nearest,
  );
  return { ...best, distance: clamp(best.distance, OPENING_DISTANCES[0], OPENING_DISTANCES[1]) };
}

/**
 * @param {number} value
 * @param {number} min
 * @param {number} max
 */
function clamp(value, min, max) {
  return Math.max(min, Math.min(max, value));
}
