/**
 * "Balance": shifts the torso over fixed feet until the centre of mass is above the support polygon. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./body.js').Posture} Posture
 * @typedef {import('./balance.js').Balance} Balance
 * @typedef {import('./editor-state.js').EditorState} EditorState
 *
 * @typedef {object} Balanced
 * @property {number[]} posture unchanged if it was already balanced or cannot be balanced
 * @property {'before' | 'now' | 'never'} when
 * @property {string} reason why it cannot be balanced
 *
 * @typedef {object} BalanceReport
 * @property {number} before number of keyframes that were already balanced
 * @property {number} now number of keyframes that the shift has balanced
 * @property {Array<{index: number, reason: string}>} never
 */
import { balanceOf } from './balance.js';
import { cornersOf, linkIndex, placed, pointOf, posesOf } from './body.js';
import { documentOf, edited, framesOf } from './editor-state.js';
import { mapKeyframes } from './motion-document.js';
import { jointName, linkName } from './names.js';
import { chainJoints, torsoMoved } from './reach.js';
import { chosenFrames } from './selection.js';

/** Target distance of the centre of mass from the edge of the support polygon. */
const WANTED_METRES = 0.01;

/** Tolerance for rounded angles. */
const ROUNDING_METRES = 0.001;
const ROUNDS = 14;
const TOUCH_METRES = 0.012;
const SLIP_METRES = 0.004;
const AT_LIMIT_DEGREES = 0.3;
const FEET = ['lfoot', 'rfoot'];

/**
 * @param {EditorState} state
 * @returns {{state: EditorState, report: BalanceReport}} the result for the selected keyframes if there are several, otherwise for all
 *     keyframes
 */
export function madeBalanced(state) {
  const chosen = chosenFrames(state);
  const all = framesOf(state).map((_, index) => index);
  const judged = chosen.length > 1 ? chosen : all;
  /** @type {BalanceReport} */
  const report = { before: 0, now: 0, never: [] };
  const document = mapKeyframes(documentOf(state), (frame, index) => {
    if (!judged.includes(index)) {
      return frame;
    }
    const { posture, when, reason } = balancedPosture(state.body, frame.degrees, state.manner);
    if (when === 'never') {
      report.never.push({ index, reason });
    } else {
      report[when] += 1;
    }
    return when === 'now' ? { ...frame, degrees: posture } : frame;
  });
  return { state: edited(state, document, 'Balance'), report };
}

/**
 * @param {Body} body
 * @param {Posture} posture
 * @param {'upright' | 'soles'} manner
 * @returns {Balanced}
 */
export function balancedPosture(body, posture, manner) {
  const torso = placed(body, posture, manner);
  const poses = posesOf(body, posture, torso);
  const balance = balanceOf(body, poses);
  if (balance.margin >= WANTED_METRES) {
    return { posture: [...posture], when: 'before', reason: '' };
  }
  const problem = supportProblem(body, poses, balance);
  if (problem) {
    return { posture: [...posture], when: 'never', reason: problem };
  }
  const shifted = shiftedOver(body, posture, torso);
  const margin = marginOf(body, shifted, manner);
  return margin >= WANTED_METRES - ROUNDING_METRES
    ? { posture: shifted, when: 'now', reason: '' }
    : { posture: [...posture], when: 'never', reason: reachProblem(body, shifted, margin) };
}

/** @param {Body} body @param {Posture} posture @param {'upright' | 'soles'} manner */
function marginOf(body, posture, manner) {
  return balanceOf(body, posesOf(body, posture, placed(body, posture, manner))).margin;
}

/** @param {Body} body @param {Posture} posture @param {number[]} torso @returns {number[]} the nearest reachable posture */
function shiftedOver(body, posture, torso) {
  const soles = solesOf(body, posesOf(body, posture, torso));
  let best = { posture: [...posture], torso };
  for (let round = 0; round < ROUNDS; round++) {
    const balance = balanceOf(body, posesOf(body, best.posture, best.torso));
    const way = wayInside(balance);
    if (way[0] === 0 && way[1] === 0) {
      break;
    }
    const next = torsoMoved(body, best.posture, best.torso, [...way, 0]);
    if (slipOf(soles, solesOf(body, posesOf(body, next.posture, next.torso))) > SLIP_METRES) {
      break;
    }
    best = next;
  }
  return best.posture.map((angle, i) => (angle === posture[i] ? angle : Math.round(100 * angle) / 100 + 0));
}

/**
 * Returns the displacement that moves the centre of mass away from edges that are too close.
 *
 * @param {Balance} balance
 * @returns {[number, number]} metres
 */
function wayInside({ support, centre }) {
  /** @type {[number, number]} */
  const way = [0, 0];
  support.forEach((corner, i) => {
    const next = support[(i + 1) % support.length];
    const length = Math.hypot(next[0] - corner[0], next[1] - corner[1]);
    const inwards = [(corner[1] - next[1]) / length, (next[0] - corner[0]) / length];
    const inside = inwards[0] * (centre[0] - corner[0]) + inwards[1] * (centre[1] - corner[1]);
    const missing = WANTED_METRES + ROUNDING_METRES - inside - (inwards[0] * way[0] + inwards[1] * way[1]);
    if (missing > 1e-4) {
      way[0] += missing * inwards[0];
      way[1] += missing * inwards[1];
    }
  });
  return way;
}

/** @param {Body} body @param {Float64Array} poses @returns {number[][]} the centres of both soles */
function solesOf(body, poses) {
  return FEET.map((name) => pointOf(poses, linkIndex(body, name), [0, 0, 0]));
}

/** @param {number[][]} before @param {number[][]} after @returns {number} distance that a foot has slipped, metres */
function slipOf(before, after) {
  return Math.max(...before.map((foot, i) => Math.hypot(...foot.map((value, axis) => value - after[i][axis]))));
}

/**
 * Explains why the legs cannot balance the robot; this is possible only for a robot on its feet.
 *
 * @param {Body} body
 * @param {Float64Array} poses
 * @param {Balance} balance
 */
function supportProblem(body, poses, { support }) {
  const other = body.model.links.findIndex(
    (link, i) =>
      body.links[i].solid &&
      !FEET.includes(link.name) &&
      cornersOf(link.size, poses, i).some((corner) => corner[2] < TOUCH_METRES),
  );
  if (other >= 0) {
    return `the robot rests on its ${linkName(body.model.links[other].name)}, not on its feet`;
  }
  return support.length < 3 ? 'no sole lies flat on the ground' : '';
}

/** @param {Body} body @param {Posture} posture shifted as far as possible @param {number} margin metres */
function reachProblem(body, posture, margin) {
  const joints = FEET.flatMap((name) => chainJoints(body, linkIndex(body, name)));
  const stuck = joints.find((joint) => {
    const { minDegrees, maxDegrees } = body.joints[joint];
    return Math.min(posture[joint] - minDegrees, maxDegrees - posture[joint]) < AT_LIMIT_DEGREES;
  });
  const missing = `${Math.max(0.1, 100 * (WANTED_METRES - margin)).toFixed(1)} cm short of balance`;
  return stuck === undefined
    ? `the legs are not long enough, still ${missing}`
    : `the ${jointName(body.joints[stuck].name)} is at its limit, still ${missing}`;
}

/** @param {BalanceReport} report @returns {string} a sentence */
export function balanceText({ before, now, never }) {
  const counts = [
    now > 0 ? `${countText(now)} shifted` : '',
    before > 0 ? `${countText(before)} ${before === 1 ? 'was' : 'were'} already balanced` : '',
    never.length > 0 ? `${countText(never.length)} cannot be balanced` : '',
  ];
  return `${counts.filter(Boolean).join(', ')}.`;
}

/** @param {number} count */
function countText(count) {
  return count === 1 ? '1 keyframe' : `${count} keyframes`;
}
