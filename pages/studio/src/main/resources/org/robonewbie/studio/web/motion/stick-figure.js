/** Small stick figure of a posture for the timeline. */
import { POSE } from '../state/kinematics.js';
import { linkIndex, placed, posesOf } from '../state/motion/body.js';

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
const PIXELS_PER_METRE = 62;

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
  const at = (/** @type {string} */ name) => {
    const i = linkIndex(body, name) * POSE;
    const across = -poses[i] * Math.cos(AZIMUTH) + poses[i + 1] * Math.sin(AZIMUTH);
    return `${(PIXELS_PER_METRE * across).toFixed(1)} ${(-PIXELS_PER_METRE * poses[i + 2]).toFixed(1)}`;
  };
  const spine = `M${at('head')}L${at('body')}`;
  const path = [spine, ...BONES.slice(1).map(([from, to]) => `M${at(from)}L${at(to)}`)].join('');
  drawn.set(posture, path);
  return path;
}

/** @param {Body} body @param {readonly number[]} posture @returns {number[]} centre of the head in the same drawing */
export function headOf(body, posture) {
  const [x, y] = (/M(\S+) (\S+)L/.exec(stickFigure(body, posture)) ?? []).slice(1).map(Number);
  return [x ?? 0, y ?? 0];
}
