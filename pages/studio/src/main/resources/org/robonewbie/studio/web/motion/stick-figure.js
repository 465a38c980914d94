/** Small stick figure of a posture for the timeline. */
import { POSE } from '../state/kinematics.js';
import { figureOf } from '../state/figure.js';
import { placed, posesOf } from '../state/motion/body.js';

/** @typedef {import('../state/motion/body.js').Body} Body */

const BONES = [
  ['head', 'body'],
  ['lupperarm', 'llowerarm'],
  ['rupperarm', 'rlowerarm'],
  ['lupperarm', 'rupperarm'],
  ['body', 'lhip1'],
  ['body', 'rhip1'],
  ['lhip1', 'lshank'],
  ['lshank', 'lankle'],
  ['lankle', 'lfoot'],
  ['rhip1', 'rshank'],
  ['rshank', 'rankle'],
  ['rankle', 'rfoot'],
];
const AZIMUTH = (35 * Math.PI) / 180;
const FIGURE_PIXELS = 36;

/** @type {WeakMap<readonly number[], string>} */
const drawn = new WeakMap();

/**
 * @param {Body} body
 * @param {readonly number[]} posture
 * @returns {string} an SVG path; the origin is on the ground between the feet
 */
export function stickFigure(body, posture) {
  const known = drawn.get(posture);
  if (known) {
    return known;
  }
  const poses = posesOf(body, posture, placed(body, posture, 'soles'));
  const perMetre = FIGURE_PIXELS / figureOf(body.model).height;
  const at = (/** @type {number} */ link) => {
    const i = link * POSE;
    const across = -poses[i] * Math.cos(AZIMUTH) + poses[i + 1] * Math.sin(AZIMUTH);
    return `${(perMetre * across).toFixed(1)} ${(-perMetre * poses[i + 2]).toFixed(1)}`;
  };
  const path = bonesOf(body)
    .map(([from, to]) => `M${at(from)}L${at(to)}`)
    .join('');
  drawn.set(posture, path);
  return path;
}

/** @param {Body} body @returns {number[][]} pairs of links, that of the head first */
function bonesOf({ isNao, model }) {
  if (isNao) {
    return BONES.map((bone) => bone.map((name) => model.links.findIndex((link) => link.name === name)));
  }
  const { head } = figureOf(model);
  const bones = model.hinges.map(({ parent, child }) => [child, parent]);
  return [...bones.filter(([child]) => child === head), ...bones.filter(([child]) => child !== head)];
}

/** @param {Body} body @param {readonly number[]} posture @returns {number[]} centre of the head in the same drawing */
export function headOf(body, posture) {
  const [x, y] = (/M(\S+) (\S+)L/.exec(stickFigure(body, posture)) ?? []).slice(1).map(Number);
  return [x ?? 0, y ?? 0];
}
