/**
 * Fits the limb design of robot type 0 to other types: longer limbs are stretched along the bone, so that they reach from joint to joint.
 * Pure.
 *
 * @typedef {import('./kinematics.js').RobotModel} RobotModel
 *
 * @typedef {object} Fit
 * @property {number[]} scale
 * @property {number[]} offset metres
 */

/** Joint positions of the design: the axis of the bone, and its inner and outer ends. */
const BONES = {
  upperarm: { axis: 1, inner: -0.02, outer: 0.07 },
  thigh: { axis: 2, inner: 0.04, outer: -0.08 },
  shank: { axis: 2, inner: 0.045, outer: -0.055 },
};

const FOOT_LENGTH = 0.16;

/**
 * Computes the fit of a link's design.
 *
 * @param {RobotModel} model
 * @param {number} link index
 * @returns {Fit}
 */
export function limbFit(model, link) {
  const fit = { scale: [1, 1, 1], offset: [0, 0, 0] };
  const kind = model.links[link].name.slice(1);
  if (kind === 'foot') {
    fit.scale[1] = model.links[link].size[1] / FOOT_LENGTH;
  }
  if (kind in BONES) {
    const { axis, inner, outer } = BONES[/** @type {keyof typeof BONES} */ (kind)];
    const place = model.links[link].position[axis];
    const from = anchorOf(model, (hinge) => hinge.child === link)[axis] - place;
    const to = anchorOf(model, (hinge) => hinge.parent === link)[axis] - place;
    fit.scale[axis] = (to - from) / (outer - inner);
    fit.offset[axis] = from - fit.scale[axis] * inner;
  }
  return fit;
}

/**
 * @param {RobotModel} model
 * @param {(hinge: import('./kinematics.js').Hinge) => boolean} wanted
 */
function anchorOf(model, wanted) {
  return /** @type {import('./kinematics.js').Hinge} */ (model.hinges.find(wanted)).anchor;
}
