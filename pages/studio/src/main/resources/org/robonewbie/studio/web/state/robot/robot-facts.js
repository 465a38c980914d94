/**
 * Ground truth about one robot in the current frame. Pure.
 *
 * @typedef {import('../../live/state-frame.js').Scene} Scene
 * @typedef {import('../../live/state-frame.js').Frame} Frame
 *
 * @typedef {object} TrueThing
 * @property {string} name
 * @property {'ball' | 'mate' | 'opponent' | 'post'} kind
 * @property {number[]} position horizontal position relative to the torso in metres: forward, left
 */
import { headingDegrees, rotated } from '../kinematics.js';

const LYING_COSINE = 0.5;

/**
 * @param {Scene} scene
 * @param {Frame} frame
 * @param {number} robot index
 * @returns {TrueThing[]} ball, other robots and goal posts
 */
export function thingsAround(scene, frame, robot) {
  const { torso } = frame.robots[robot];
  const player = scene.robots[robot];
  const things = [/** @type {TrueThing} */ ({ name: 'ball', kind: 'ball', position: seenFrom(torso, frame.ball) })];
  frame.robots.forEach((other, i) => {
    const { side, team, number } = scene.robots[i];
    if (i !== robot) {
      const kind = side === player.side ? 'mate' : 'opponent';
      things.push({ name: `${team} ${number}`, kind, position: seenFrom(torso, other.torso) });
    }
  });
  for (const x of [-1, 1]) {
    for (const y of [-1, 1]) {
      const place = [(x * scene.field.length) / 2, (y * scene.field.goalWidth) / 2];
      things.push({ name: 'goal post', kind: 'post', position: seenFrom(torso, place) });
    }
  }
  return things;
}

/**
 * @param {ArrayLike<number>} torso pose of the robot
 * @param {ArrayLike<number>} place x and y in the world
 * @returns {number[]} the same position relative to the robot: metres forward and left
 */
export function seenFrom(torso, place) {
  const heading = (headingDegrees(torso) * Math.PI) / 180;
  const [dx, dy] = [place[0] - torso[0], place[1] - torso[1]];
  return [dx * Math.cos(heading) + dy * Math.sin(heading), dy * Math.cos(heading) - dx * Math.sin(heading)];
}

/**
 * @param {Frame} frame
 * @param {number} robot
 * @returns {{x: number, y: number, height: number, heading: number, tilt: number, stands: boolean, ball: number}}
 */
export function placeOf(frame, robot) {
  const { torso } = frame.robots[robot];
  const upright = rotated(torso, 0, [0, 0, 1])[2];
  return {
    x: torso[0],
    y: torso[1],
    height: torso[2],
    heading: headingDegrees(torso),
    tilt: (Math.acos(Math.max(-1, Math.min(1, upright))) * 180) / Math.PI,
    stands: upright >= LYING_COSINE,
    ball: Math.hypot(frame.ball[0] - torso[0], frame.ball[1] - torso[1]),
  };
}

/**
 * Returns the believed position of a robot relative to its true one.
 *
 * @param {ArrayLike<number>} torso true pose
 * @param {string} side side of its team; the coordinates of the right team are rotated by 180 degrees
 * @param {number[]} self believed x, y in metres and heading in degrees, with the opponents' goal at positive x
 * @returns {{position: number[], heading: number}} metres forward and left; heading in the world in degrees
 */
export function believedPlace(torso, side, [x, y, degrees]) {
  const sign = side === 'right' ? -1 : 1;
  return { position: seenFrom(torso, [sign * x, sign * y]), heading: sign < 0 ? degrees + 180 : degrees };
}
