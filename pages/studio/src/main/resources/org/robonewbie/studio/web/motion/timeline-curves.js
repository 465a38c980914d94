/** Curves of the selected joints, with the angles that the physically simulated robot reached. */
import { label, shape } from '../panels/drawing.js';
import { framesOf } from '../state/motion/editor-state.js';
import { chosenFrames, chosenJoints } from '../state/motion/selection.js';
import { timesOf } from '../state/motion/timing.js';
import { roundStep } from '../state/numbers.js';

/**
 * @typedef {import('../state/motion/editor-state.js').EditorState} EditorState
 * @typedef {import('../state/motion/lag.js').Lag} Lag
 * @typedef {import('./timeline-scale.js').TimeScale} TimeScale
 *
 * @typedef {object} AngleScale
 * @property {number} height pixels
 * @property {number} low degrees at the bottom
 * @property {number} high degrees at the top
 * @property {(degrees: number) => number} y
 * @property {(y: number) => number} degrees
 */

const EDGE = 10;
const MIN_DEGREES = 30;
const COLOURS = 6;
const MIN_STEP = 5;
const MAX_LINES = 6;

/**
 * @param {EditorState} state
 * @param {number} height pixels
 * @param {Lag | undefined} lag
 * @returns {AngleScale} a scale that covers the curves and nearby limits
 */
export function angleScale(state, height, lag) {
  const joints = chosenJoints(state);
  const frames = framesOf(state);
  const angles = joints.flatMap((joint) => [
    ...frames.map(({ degrees }) => degrees[joint]),
    ...(lag?.reached.map((posture) => posture[joint]) ?? []),
  ]);
  const [min, max] = angles.length > 0 ? [Math.min(...angles), Math.max(...angles)] : [0, 0];
  const room = Math.max(4, 0.15 * (max - min), (MIN_DEGREES - (max - min)) / 2);
  const [low, high] = [min - room, max + room];
  const perDegree = Math.max(1, height - 2 * EDGE) / (high - low);
  return {
    height,
    low,
    high,
    y: (degrees) => EDGE + (high - degrees) * perDegree,
    degrees: (y) => high - (y - EDGE) / perDegree,
  };
}

/** @param {EditorState} state @param {number} joint @returns {string} CSS class for the colour of its curve */
export function curveColour(state, joint) {
  return `curve-${Math.max(0, chosenJoints(state).indexOf(joint)) % COLOURS}`;
}

/**
 * @param {EditorState} state
 * @param {TimeScale} scale
 * @param {AngleScale} angles
 * @param {Lag | undefined} lag
 * @returns {SVGElement[]}
 */
export function drawCurves(state, scale, angles, lag) {
  const joints = chosenJoints(state);
  return [
    ...drawGrid(scale, angles),
    ...(joints.length === 1 ? drawLimits(state, joints[0], scale, angles) : []),
    ...joints.map((joint) => drawCurve(state, joint, scale, angles, lag)),
  ];
}

/** @param {TimeScale} scale @param {AngleScale} angles */
function drawGrid({ width }, { low, high, y }) {
  const step = Math.max(MIN_STEP, roundStep((high - low) / MAX_LINES));
  const parts = [];
  for (let degrees = Math.ceil(low / step) * step; degrees <= high; degrees += step) {
    parts.push(
      shape('line', { class: 'tick', x1: 0, x2: width, y1: y(degrees), y2: y(degrees) }),
      label(`${degrees}°`, 2, y(degrees) - 2, 'tick-text'),
    );
  }
  return parts;
}

/** @param {EditorState} state @param {number} joint @param {TimeScale} scale @param {AngleScale} angles */
function drawLimits({ body }, joint, { width }, { low, high, height, y }) {
  const { minDegrees, maxDegrees } = body.joints[joint];
  const beyond = (/** @type {number} */ from, /** @type {number} */ to) =>
    shape('rect', { class: 'out-of-range', x: 0, width, y: from, height: Math.max(0, to - from) });
  return [
    ...(maxDegrees < high ? [beyond(0, y(maxDegrees))] : []),
    ...(minDegrees > low ? [beyond(y(minDegrees), height)] : []),
  ];
}

/**
 * @param {EditorState} state
 * @param {number} joint
 * @param {TimeScale} scale
 * @param {AngleScale} angles
 * @param {Lag | undefined} lag
 */
function drawCurve(state, joint, scale, angles, lag) {
  const frames = framesOf(state);
  const times = timesOf(frames);
  const chosen = new Set(chosenFrames(state));
  const place = (/** @type {number} */ time, /** @type {number} */ degrees) =>
    `${scale.x(time).toFixed(1)},${angles.y(degrees).toFixed(1)}`;
  const points = frames.map(({ degrees }, i) => place(times[i], degrees[joint]));
  const reached = lag?.reached.map((posture, i) => place(i * lag.frameMillis, posture[joint])) ?? [];
  const group = shape(
    'g',
    { class: curveColour(state, joint), 'data-curve': joint },
    shape('polyline', { class: 'curve', points: points.join(' ') }),
    ...(reached.length > 0 ? [shape('polyline', { class: 'reached', points: reached.join(' ') })] : []),
    ...points.map((each, i) => {
      const [cx, cy] = each.split(',');
      return shape('circle', { class: chosen.has(i) ? 'point chosen' : 'point', cx, cy, r: chosen.has(i) ? 5 : 3.5 });
    }),
  );
  return group;
}
