/** The timeline of a motion: keyframes with small figures, marks for what is not possible, a joint's curve, the playhead. */
import { headOf, stickFigure } from './stick-figure.js';
import { framesOf, lengthOf, playableLength, selectionOf } from '../state/motion/editor-state.js';
import { jointName, shortJointName } from '../state/motion/names.js';
import { secondsText, timesOf } from '../state/motion/timing.js';

/**
 * @typedef {import('../state/motion/editor-state.js').EditorState} EditorState
 * @typedef {import('../state/motion/checks.js').Mark} Mark
 */

const SVG = 'http://www.w3.org/2000/svg';
const SIDE = 30;
const RULER = 18;
const FIGURE_GROUND = 66;
const CURVE_TOP = 72;
const CURVE_HEIGHT = 34;
const MARK_TOP = 112;
const MARK_ROW = 8;
const LEAST_GAP = 34;
const TICK_TEXT_WIDTH = 40;

/** @type {Array<{kind: Mark['kind'], name: string}>} */
export const MARK_KINDS = [
  { kind: 'speed', name: 'too fast' },
  { kind: 'range', name: 'out of range' },
  { kind: 'collision', name: 'limbs touch' },
  { kind: 'balance', name: 'tips over' },
];

const KEYFRAME_HINT = 'Drag to change the time, Shift-click to choose several.';

export class Timeline {
  /**
   * @param {HTMLElement} place
   * @param {object} editor
   * @param {(index: number, extending: boolean) => void} editor.select
   * @param {(time: number) => void} editor.scrub
   * @param {(index: number, millis: number, gesture: string) => void} editor.setTime
   */
  constructor(place, editor) {
    this.place = place;
    this.editor = editor;
    this.svg = node('svg', { class: 'timeline-drawing' });
    this.still = node('g', {});
    this.playhead = node('g', { class: 'playhead' });
    this.playhead.append(node('line', { y1: '0', y2: '150' }), node('path', { d: 'M-6 0h12l-6 9z' }));
    this.svg.append(this.still, this.playhead);
    place.append(this.svg);
    place.tabIndex = 0;
    this.scale = 0.1;
    this.gestures = 0;
    /** @type {{index: number, x: number, millis: number, gesture: string} | undefined} */
    this.grip = undefined;
    this.scrubs = false;
    /** @type {EditorState | undefined} */
    this.state = undefined;
    place.addEventListener('pointerdown', (event) => this.#press(event));
    place.addEventListener('pointermove', (event) => this.#drag(event));
    for (const end of ['pointerup', 'pointercancel']) {
      place.addEventListener(end, () => {
        this.grip = undefined;
        this.scrubs = false;
      });
    }
  }

  /**
   * @param {EditorState} state
   * @param {readonly Mark[]} marks
   */
  draw(state, marks) {
    this.state = state;
    const width = this.place.clientWidth;
    const most = Math.max(lengthOf(state), playableLength(state), 400);
    if (!this.grip) {
      this.scale = (width - 2 * SIDE) / most;
    }
    this.svg.setAttribute('width', String(width));
    this.still.replaceChildren(
      ...this.#ruler(most),
      ...this.#curve(state),
      ...this.#marks(marks),
      ...this.#trial(state),
      ...this.#keyframes(state),
    );
    this.movePlayhead(state);
  }

  /** @param {EditorState} state */
  movePlayhead({ time }) {
    this.playhead.setAttribute('transform', `translate(${this.#x(time).toFixed(1)} 0)`);
  }

  /** @param {number} time */
  #x(time) {
    return SIDE + time * this.scale;
  }

  /** @param {number} most */
  #ruler(most) {
    const step = [100, 200, 500, 1000, 2000, 5000, 10_000].find((each) => each * this.scale > 56) ?? 20_000;
    const parts = [node('rect', { class: 'ruler', x: '0', y: '0', width: '100%', height: String(RULER) })];
    for (let time = 0; time <= most; time += step) {
      const x = this.#x(time).toFixed(1);
      parts.push(node('line', { class: 'tick', x1: x, x2: x, y1: String(RULER - 5), y2: '150' }));
      const isLast = Number(x) + TICK_TEXT_WIDTH > this.place.clientWidth;
      const anchor = isLast ? 'end' : 'start';
      const label = { class: 'tick-text', x: String(Number(x) + (isLast ? -4 : 4)), y: '13', 'text-anchor': anchor };
      parts.push(text(`${time / 1000} s`, label));
    }
    return parts;
  }

  /** @param {EditorState} state */
  #curve(state) {
    const frames = framesOf(state);
    const joint = state.body.joints[state.joint];
    const times = timesOf(frames);
    const y = (/** @type {number} */ degrees) =>
      CURVE_TOP + (CURVE_HEIGHT * (joint.maxDegrees - degrees)) / (joint.maxDegrees - joint.minDegrees);
    const points = frames.map(
      ({ degrees }, i) => `${this.#x(times[i]).toFixed(1)},${y(degrees[state.joint]).toFixed(1)}`,
    );
    return [
      node('rect', {
        class: 'curve-range',
        x: String(SIDE),
        y: String(CURVE_TOP),
        width: String(Math.max(0, this.#x(lengthOf(state)) - SIDE)),
        height: String(CURVE_HEIGHT),
      }),
      node('polyline', { class: 'curve', points: points.join(' ') }),
      text(
        shortJointName(joint.name),
        { class: 'curve-name', x: '4', y: String(CURVE_TOP + CURVE_HEIGHT - 3) },
        `Angle of the ${jointName(joint.name)}`,
      ),
    ];
  }

  /** @param {readonly Mark[]} marks */
  #marks(marks) {
    return marks.map((mark) => {
      const row = MARK_KINDS.findIndex(({ kind }) => kind === mark.kind);
      const x = this.#x(mark.from) - (mark.from === mark.to ? 3 : 0);
      const bar = node('rect', {
        class: `mark ${mark.kind}`,
        x: x.toFixed(1),
        y: String(MARK_TOP + row * MARK_ROW),
        width: Math.max(6, (mark.to - mark.from) * this.scale).toFixed(1),
        height: String(MARK_ROW - 2),
        rx: '2',
      });
      bar.append(title(mark.text));
      return bar;
    });
  }

  /** @param {EditorState} state */
  #trial({ trial }) {
    if (trial?.fallSeconds === undefined) {
      return [];
    }
    const x = this.#x(1000 * trial.fallSeconds);
    const group = node('g', { class: 'fall', transform: `translate(${x.toFixed(1)} 0)` });
    group.append(node('line', { y1: String(RULER), y2: '150' }), text('falls', { x: '4', y: '32' }));
    return [group];
  }

  /** @param {EditorState} state */
  #keyframes(state) {
    const frames = framesOf(state);
    const times = timesOf(frames);
    const [from, to] = selectionOf(state);
    let lastFigure = -Infinity;
    return frames.map((frame, i) => {
      const x = this.#x(times[i]);
      const isChosen = i >= from && i <= to;
      const hasFigure = x - lastFigure >= LEAST_GAP || isChosen;
      lastFigure = hasFigure ? x : lastFigure;
      const group = keyframeGroup(x, i, times[i], isChosen);
      group.append(
        node('rect', { class: 'card', x: '-15', y: String(RULER + 2), width: '30', height: '50', rx: '5' }),
        ...(hasFigure ? [figureOf(state.body, frame.degrees)] : []),
        node('path', { class: 'diamond', d: `M0 ${CURVE_TOP - 6}l6 6l-6 6l-6-6z` }),
        title(`Keyframe ${i + 1}, ${frame.millis} ms after the one before. ${KEYFRAME_HINT}`),
      );
      return group;
    });
  }

  /** @param {PointerEvent} event */
  #press(event) {
    const target = /** @type {Element} */ (event.target).closest('[data-keyframe]');
    this.place.setPointerCapture(event.pointerId);
    if (target && this.state) {
      const index = Number(target.getAttribute('data-keyframe'));
      const { millis } = framesOf(this.state)[index];
      this.grip = { index, x: event.clientX, millis, gesture: `time ${++this.gestures}` };
      this.editor.select(index, event.shiftKey);
    } else {
      this.scrubs = true;
      this.#scrub(event);
    }
  }

  /** @param {PointerEvent} event */
  #drag(event) {
    const { grip } = this;
    if (grip && Math.abs(event.clientX - grip.x) > 3) {
      this.editor.setTime(grip.index, grip.millis + (event.clientX - grip.x) / this.scale, grip.gesture);
    } else if (this.scrubs) {
      this.#scrub(event);
    }
  }

  /** @param {PointerEvent} event */
  #scrub(event) {
    const x = event.clientX - this.place.getBoundingClientRect().left;
    this.editor.scrub((x - SIDE) / this.scale);
  }
}

/**
 * @param {string} name
 * @param {Record<string, string>} attributes
 */
function node(name, attributes) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) {
    made.setAttribute(key, value);
  }
  return /** @type {SVGElement} */ (made);
}

/** @param {string} content @param {Record<string, string>} attributes @param {string} [hint] */
function text(content, attributes, hint) {
  const made = node('text', attributes);
  made.textContent = content;
  if (hint) {
    made.append(title(hint));
  }
  return made;
}

/** @param {string} content */
function title(content) {
  const made = node('title', {});
  made.textContent = content;
  return made;
}

/** @param {number} x @param {number} index @param {number} time milliseconds @param {boolean} isChosen */
function keyframeGroup(x, index, time, isChosen) {
  return node('g', {
    class: `keyframe${isChosen ? ' chosen' : ''}`,
    transform: `translate(${x.toFixed(1)} 0)`,
    'data-keyframe': String(index),
    role: 'img',
    'aria-label': `Keyframe ${index + 1} at ${secondsText(time)}`,
  });
}

/** @param {EditorState['body']} body @param {readonly number[]} degrees */
function figureOf(body, degrees) {
  const figure = node('g', { class: 'figure', transform: `translate(0 ${FIGURE_GROUND})` });
  const [x, y] = headOf(body, degrees);
  figure.append(
    node('path', { d: stickFigure(body, degrees) }),
    node('circle', { cx: String(x), cy: String(y), r: '3.4' }),
  );
  return figure;
}
