/** Time line of a replay: event marks, the section that is being repeated, and the displayed moment. */
import { setAttributes, shape, title } from '../panels/drawing.js';
import { element } from '../panels/elements.js';
import { matchEventText } from '../state/match-events.js';
import { MOMENTS_PER_SECOND } from '../state/replay/replay-state.js';

/**
 * @typedef {import('../state/replay/replay-state.js').ReplayState} ReplayState
 * @typedef {import('../state/replay/recording-reader.js').RecordedEvent} RecordedEvent
 */

const SIDE = 12;
const HEIGHT = 44;

/** Each kind of event has its own colour and shape. @type {Record<RecordedEvent['kind'], string>} */
const SHAPES = {
  goal: 'M0 10l2.4 5 5.4.6-4 3.7 1.1 5.4L0 22l-4.9 2.7 1.1-5.4-4-3.7 5.4-.6z',
  fall: 'M-6 12h12L0 22z',
  foul: 'M-5 12h10v10h-10z',
  playmode: 'M-1.2 10h2.4v14h-2.4z',
  warning: 'M0 11L6 21H-6z',
  log: 'M-2.5 15h5v5h-5z',
};

/** @type {Record<RecordedEvent['kind'], string>} */
const NAMES = { goal: 'Goal', fall: 'Fall', foul: 'Foul', playmode: 'Play mode', warning: 'Warning', log: 'Log' };

/** Events of a recording name sides instead of teams. */
const SIDES = { left: 'left', right: 'right' };

export class ReplayLine {
  /**
   * @param {HTMLElement} place
   * @param {(index: number) => void} scrub
   */
  constructor(place, scrub) {
    this.place = place;
    this.scrub = scrub;
    setAttributes(place, { role: 'slider', tabindex: 0, 'aria-label': 'Moment of the recording', 'aria-valuemin': 0 });
    this.marks = shape('g');
    this.loop = shape('rect', { class: 'loop', y: 4, height: 24 });
    this.track = shape('rect', { class: 'track', x: SIDE, y: 26, height: 5, rx: 2.5 });
    this.done = shape('rect', { class: 'done', x: SIDE, y: 26, height: 5, rx: 2.5 });
    this.knob = shape('circle', { class: 'knob', cy: 28.5, r: 7 });
    const parts = [this.loop, this.track, this.done, this.marks, this.knob];
    this.svg = shape('svg', { height: HEIGHT, class: 'replay-drawing' }, ...parts);
    place.append(this.svg);
    this.count = 1;
    this.drawn = '';
    const move = (/** @type {PointerEvent} */ event) => {
      const x = event.clientX - place.getBoundingClientRect().left - SIDE;
      this.scrub((x / Math.max(1, place.clientWidth - 2 * SIDE)) * (this.count - 1));
    };
    place.addEventListener('pointerdown', (event) => {
      place.setPointerCapture(event.pointerId);
      move(event);
    });
    place.addEventListener('pointermove', (event) => place.hasPointerCapture(event.pointerId) && move(event));
  }

  /** @param {ReplayState} state @param {readonly RecordedEvent[]} events */
  draw(state, events) {
    const width = Math.max(1, this.place.clientWidth - 2 * SIDE);
    this.count = Math.max(2, state.count);
    const x = (/** @type {number} */ index) => SIDE + (width * index) / (this.count - 1);
    const [from, to] = state.loop ?? [0, 0];
    setAttributes(this.svg, { width: width + 2 * SIDE });
    setAttributes(this.track, { width });
    setAttributes(this.done, { width: Math.max(0, x(state.index) - SIDE) });
    setAttributes(this.knob, { cx: x(state.index) });
    setAttributes(this.loop, { x: x(from), width: Math.max(0, x(to) - x(from)) });
    const now = seconds(state.index);
    setAttributes(this.place, {
      'aria-valuemax': seconds(this.count - 1),
      'aria-valuenow': now,
      'aria-valuetext': `${now} s`,
    });
    const key = `${width} ${state.count} ${events.length}`;
    if (key !== this.drawn) {
      this.drawn = key;
      this.marks.replaceChildren(...events.map((event) => markOf(event, x(event.index))));
    }
  }
}

/** @param {RecordedEvent} event @param {number} x */
function markOf(event, x) {
  const transform = `translate(${x.toFixed(1)} -7)`;
  const look = { d: SHAPES[event.kind], class: `event ${event.kind}`, transform };
  return shape('path', look, title(eventText(event)));
}

/** Creates the legend of the marks. */
export function legend() {
  const kinds = /** @type {Array<RecordedEvent['kind']>} */ (Object.keys(NAMES));
  const entries = kinds.map((kind) => {
    const sign = shape('path', { d: SHAPES[kind], class: `event-sign ${kind}` });
    const mark = shape('svg', { viewBox: '-7 8 14 18', 'aria-hidden': 'true' }, sign);
    return element('span', {}, mark, NAMES[kind]);
  });
  return element('p', { class: 'replay-legend faint' }, ...entries);
}

/** @param {RecordedEvent} event @returns {string} */
export function eventText({ kind, text, index }) {
  const sentence = kind === 'foul' ? matchEventText(`foul ${text}`, SIDES) : `${NAMES[kind]}: ${text}`;
  return `${seconds(index)} s · ${sentence}`;
}

/** @param {number} index @returns {string} */
function seconds(index) {
  return (index / MOMENTS_PER_SECOND).toFixed(1);
}
