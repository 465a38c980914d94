/** Finds goals that stand between the camera and a robot. Pure. */
import { eye, robotOutline } from './view-point.js';

/**
 * @typedef {object} Face one side of a goal, which is treated as a solid wedge
 * @property {(point: readonly number[]) => number} depth distance of a point from this side, negative outside the goal
 * @property {boolean} isOpen whether this side has no net
 */

/** Distance at which a line of sight passes a post without touching it, metres. */
const MARGIN = 0.1;

/**
 * @param {import('../live/state-frame.js').Field} field
 * @param {number} end -1 for the left goal, 1 for the right goal
 * @param {import('./view-point.js').ViewPoint} view a view of a robot
 * @returns {boolean} whether a post, the bar or the net of the goal is in front of the robot
 */
export function hidesRobot(field, end, view) {
  const faces = facesOf(field, end);
  const from = eye(view);
  return robotOutline(view).some((point) => isCrossed(faces, from, point));
}

/**
 * Returns the sides of a goal: the open mouth, both side nets, and the net that slopes from the crossbar to the ground.
 *
 * @param {import('../live/state-frame.js').Field} field
 * @param {number} end
 * @returns {Face[]}
 */
function facesOf({ length, goalWidth, goalDepth, goalHeight }, end) {
  const behindLine = (/** @type {readonly number[]} */ [x]) => end * x - length / 2;
  const side = goalWidth / 2 + MARGIN;
  return [
    { depth: (point) => behindLine(point) + MARGIN, isOpen: true },
    { depth: ([, y]) => side - y, isOpen: false },
    { depth: ([, y]) => side + y, isOpen: false },
    { depth: (point) => goalHeight * (1 - behindLine(point) / goalDepth) + MARGIN - point[2], isOpen: false },
  ];
}

/**
 * Clips the line of sight at all faces and returns whether the remaining segment begins or ends at a net.
 *
 * @param {readonly Face[]} faces
 * @param {readonly number[]} from
 * @param {readonly number[]} to
 */
function isCrossed(faces, from, to) {
  let [enter, exit] = [
    { at: 0, isOpen: true },
    { at: 1, isOpen: true },
  ];
  for (const { depth, isOpen } of faces) {
    const [start, stop] = [depth(from), depth(to)];
    const at = start / (start - stop);
    if (start < 0 && stop < 0) {
      return false;
    }
    if (start < 0 && at > enter.at) {
      enter = { at, isOpen };
    } else if (stop < 0 && at < exit.at) {
      exit = { at, isOpen };
    }
  }
  return enter.at < exit.at && !(enter.isOpen && exit.isOpen);
}
