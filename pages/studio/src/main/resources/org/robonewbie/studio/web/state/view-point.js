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
const FARTHEST = 90;
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
    clamp(x + view.distance * (-sine * right - cosine * up), -FARTHEST, FARTHEST),
    clamp(y + view.distance * (cosine * right - sine * up), -FARTHEST, FARTHEST),
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
 * Moves the camera as close as possible while keeping all points visible.
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

const ROBOT_HEIGHT = 0.58;
const ROBOT_REACH = 0.3;

/** Fraction of the free height that a robot fills. */
const ROBOT_SHARE = 0.5;
const FRONT_RIGHT_DEGREES = 50;
const ROBOT_ELEVATION_DEGREES = 13;

/**
 * Returns the point of a robot on which the camera is centred.
 *
 * @param {ArrayLike<number>} torso pose of its torso
 * @param {number} [height] height of the robot in metres; by default that of a NAO
 */
export function robotCentre(torso, height = ROBOT_HEIGHT) {
  return [torso[0], torso[1], height / 2];
}

/**
 * Returns the three-quarter view of a robot from its front right: a raised left arm does not hide the face, and a ball in front of the
 * robot is visible.
 *
 * @param {readonly number[]} centre see {@link robotCentre}
 * @param {number} headingDegrees
 * @param {FreeView} free
 * @param {number} [height] height of the robot in metres; by default that of a NAO
 * @returns {ViewPoint}
 */
export function robotView(centre, headingDegrees, { across, up }, height = ROBOT_HEIGHT) {
  const view = {
    target: [...centre],
    azimuthDegrees: headingDegrees - FRONT_RIGHT_DEGREES,
    elevationDegrees: ROBOT_ELEVATION_DEGREES,
    distance: FARTHEST,
  };
  return fitted(view, robotOutline(view, height), { across, up: ROBOT_SHARE * up });
}

/**
 * Returns the outermost points of a standing robot as seen from the camera.
 *
 * @param {ViewPoint} view
 * @param {number} [height] height of the robot in metres; by default that of a NAO
 * @returns {number[][]}
 */
export function robotOutline({ target: [x, y, z], azimuthDegrees }, height = ROBOT_HEIGHT) {
  const right = (azimuthDegrees + 90) * RADIANS;
  const reach = (ROBOT_REACH * height) / ROBOT_HEIGHT;
  const [dx, dy] = [reach * Math.cos(right), reach * Math.sin(right)];
  return [
    [x, y, z - height / 2],
    [x, y, z + height / 2],
    [x - dx, y - dy, z],
    [x + dx, y + dy, z],
  ];
}

/**
 * @param {number} value
 * @param {number} min
 * @param {number} max
 */
function clamp(value, min, max) {
  return Math.max(min, Math.min(max, value));
}
