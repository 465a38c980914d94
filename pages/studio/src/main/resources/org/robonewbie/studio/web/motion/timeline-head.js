/** The header of the timeline: the ruler, keyframes with stick figures, and fault marks. */
import { diamond, label, shape, title } from '../panels/drawing.js';
import { framesOf } from '../state/motion/editor-state.js';
import { roundStep } from '../state/numbers.js';
import { chosenFrames } from '../state/motion/selection.js';
import { secondsText, timesOf } from '../state/motion/timing.js';
import { headOf, stickFigure } from './stick-figure.js';
import { SIDE } from './timeline-scale.js';

/**
 * @typedef {import('../state/motion/editor-state.js').EditorState} EditorState
 * @typedef {import('../state/motion/checks.js').Mark} Mark
 * @typedef {import('./timeline-scale.js').TimeScale} TimeScale
 */

export const RULER = 18;
export const HEAD_HEIGHT = 74;
export const MARK_ROW = 15;
const FIGURE_GROUND = 65;
const MIN_GAP = 34;
const TICK_TEXT_WIDTH = 40;
const MIN_STEP = 20;
const TICK_GAP = 56;

/** @type {Array<{kind: Mark['kind'], name: string, meaning: string}>} */
export const MARK_KINDS = [
  { kind: 'speed', name: 'too fast', meaning: 'A motor cannot turn its joint this fast: increase the duration.' },
  { kind: 'range', name: 'out of range', meaning: 'A joint cannot turn this far: it stops at its limit.' },
  {
    kind: 'collision',
    name: 'limbs touch',
    meaning: 'Two limbs collide; a real robot could be damaged.',
  },
  {
    kind: 'balance',
    name: 'tips over',
    meaning: 'The centre of mass is not above the feet. That is acceptable for a moment in a fast motion.',
  },
];

/** @param {readonly Mark[]} marks @returns {Array<Mark['kind']>} the kinds present, each with its own row */
export function kindsOf(marks) {
  return MARK_KINDS.map(({ kind }) => kind).filter((kind) => marks.some((mark) => mark.kind === kind));
}

/** @param {TimeScale} scale @returns {SVGElement[]} */
export function drawRuler(scale) {
  const step = Math.max(MIN_STEP, roundStep(TICK_GAP / scale.perMilli));
  const parts = [shape('rect', { class: 'ruler', x: 0, y: 0, width: '100%', height: RULER })];
  for (let time = Math.ceil(scale.from / step) * step; time <= scale.from + scale.span; time += step) {
    const x = scale.x(time);
    parts.push(shape('line', { class: 'tick', x1: x, x2: x, y1: RULER - 5, y2: HEAD_HEIGHT }));
    if (x + TICK_TEXT_WIDTH < scale.width) {
      parts.push(label(`${time / 1000} s`, x + 4, 13, 'tick-text'));
    }
  }
  return parts;
}

/** @param {EditorState} state @param {TimeScale} scale @returns {SVGElement[]} */
export function drawKeyframes(state, scale) {
  const frames = framesOf(state);
  const times = timesOf(frames);
  const chosen = chosenFrames(state);
  let lastFigure = -Infinity;
  return frames.flatMap((frame, i) => {
    const x = scale.x(times[i]);
    if (x < -SIDE || x > scale.width + SIDE) {
      return [];
    }
    const isChosen = chosen.includes(i);
    const hasFigure = x - lastFigure >= MIN_GAP || i === state.last;
    lastFigure = hasFigure ? x : lastFigure;
    const group = shape(
      'g',
      {
        class: `keyframe${isChosen ? ' chosen' : ''}`,
        transform: `translate(${x.toFixed(1)} 0)`,
        'data-keyframe': i,
        role: 'img',
        'aria-label': `Keyframe ${i + 1} at ${secondsText(times[i])}`,
      },
      shape('rect', { class: 'card', x: -15, y: RULER + 2, width: 30, height: 50, rx: 5 }),
      ...(hasFigure ? [figureOf(state.body, frame.degrees)] : []),
      shape('path', { class: 'diamond', d: diamond(0, HEAD_HEIGHT - 6, 5) }),
      title(keyframeHint(i, times[i], frame.millis, state.alone)),
    );
    return [group];
  });
}

/** @param {number} index @param {number} time @param {number} millis @param {boolean} alone */
function keyframeHint(index, time, millis, alone) {
  const [now, other] = alone
    ? ['the others stay in place', 'later ones follow']
    : ['later ones follow', 'the others stay in place'];
  return (
    `Keyframe ${index + 1} at ${secondsText(time)}, ${millis} ms after the previous one. ` +
    `Drag to change its time: ${now}; with Alt, ${other}. Shift-click or Ctrl-click selects several.`
  );
}

/** @param {EditorState['body']} body @param {readonly number[]} degrees */
function figureOf(body, degrees) {
  const [cx, cy] = headOf(body, degrees);
  const limbs = shape('path', { d: stickFigure(body, degrees) });
  const attributes = { class: 'figure', transform: `translate(0 ${FIGURE_GROUND})` };
  return shape('g', attributes, limbs, shape('circle', { cx, cy, r: 3.4 }));
}

/**
 * @param {readonly Mark[]} marks
 * @param {ReadonlyArray<Mark['kind']>} rows
 * @param {TimeScale} scale
 * @returns {SVGElement[]}
 */
export function drawMarks(marks, rows, scale) {
  return marks.flatMap((mark, index) => {
    const x = scale.x(mark.from) - (mark.from === mark.to ? 4 : 0);
    const width = Math.max(8, (mark.to - mark.from) * scale.perMilli);
    if (x > scale.width || x + width < 0 || !rows.includes(mark.kind)) {
      return [];
    }
    const y = rows.indexOf(mark.kind) * MARK_ROW + 2;
    const box = { class: `mark ${mark.kind}`, x, y, width, height: MARK_ROW - 5, rx: 2, 'data-mark': index };
    return [shape('rect', box, title(`${mark.text}. Click to go there.`))];
  });
}
