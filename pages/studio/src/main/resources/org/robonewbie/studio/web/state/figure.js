/**
 * Measures of a robot's figure that views need: the NAO's are constants of its design, those of other robots follow from their shapes. Pure.
 *
 * @typedef {import('./kinematics.js').RobotModel} RobotModel
 *
 * @typedef {object} Figure
 * @property {number} height metres from the ground to the top of the head in the stance
 * @property {number} aboveTorso metres from the torso's origin to just above the head
 * @property {number} head index of the link that carries the camera
 * @property {number[]} eye position of the camera in the frame of that link
 * @property {number[]} feet indices of the links that stand on the ground
 */

const NAO = { height: 0.58, aboveTorso: 0.31, eye: [0, 0.075, 0] };
const HEAD_MOTOR = 'he2';
const FOOT = /foot/i;
const MARGIN = 0.04;

/** @type {WeakMap<RobotModel, Figure>} */
const known = new WeakMap();

/** @param {RobotModel} model @returns {boolean} whether the robot is a NAO, which has a dedicated design */
export const isNao = (model) => model.links[0].shapes === undefined;

/** @param {RobotModel} model @returns {Figure} */
export function figureOf(model) {
  const figure = known.get(model) ?? (isNao(model) ? naoFigure(model) : shapedFigure(model));
  known.set(model, figure);
  return figure;
}

/** @param {RobotModel} model @returns {Figure} */
function naoFigure({ links }) {
  const indexOf = (/** @type {string} */ name) => links.findIndex((link) => link.name === name);
  return { ...NAO, head: indexOf('head'), feet: [indexOf('rfoot'), indexOf('lfoot')] };
}

/** @param {RobotModel} model @returns {Figure} */
function shapedFigure({ links, hinges, stanceHeight = 0 }) {
  const heights = links.flatMap(({ position, shapes = [] }) =>
    shapes.map(({ position: [, , z], size }) => [position[2] + z - size[2] / 2, position[2] + z + size[2] / 2]),
  );
  const top = Math.max(0.05, ...heights.map(([, high]) => high));
  const low = Math.min(-0.05, ...heights.map(([bottom]) => bottom));
  const torso = stanceHeight > 0 ? stanceHeight : -low;
  const head = hinges.find(({ effector }) => effector === HEAD_MOTOR)?.child ?? 0;
  const eye = [0, links[head].size[1] / 2, links[head].shapes?.[0]?.position[2] ?? 0];
  const feet = links.flatMap(({ name }, i) => (FOOT.test(name) ? [i] : []));
  return { height: torso + top, aboveTorso: top + MARGIN, head, eye, feet };
}
