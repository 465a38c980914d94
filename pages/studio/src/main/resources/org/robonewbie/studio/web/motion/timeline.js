/** The timeline of a motion: keyframes and marks above, joints as rows or curves below, and the playhead across both. */
import { shape } from '../panels/drawing.js';
import { element } from '../panels/elements.js';
import { shownLength } from '../state/motion/editor-state.js';
import { jointRows } from '../state/motion/names.js';
import { secondsText } from '../state/motion/timing.js';
import { angleScale, drawCurves } from './timeline-curves.js';
import { TimelineController } from './timeline-controller.js';
import { drawKeyframes, drawMarks, drawRuler, HEAD_HEIGHT, kindsOf, MARK_ROW } from './timeline-head.js';
import { timelineKeys } from './timeline-keys.js';
import { drawRows, ROW } from './timeline-rows.js';
import { timeScale } from './timeline-scale.js';
import { jointNames, markNames, timelineSide } from './timeline-side.js';

/**
 * @typedef {import('../state/motion/editor-state.js').EditorState} EditorState
 * @typedef {import('../state/motion/checks.js').Mark} Mark
 * @typedef {import('../state/motion/lag.js').Lag} Lag
 * @typedef {import('./timeline-scale.js').TimeScale} TimeScale
 *
 * @typedef {object} TimelineEditor
 * @property {(edit: (state: EditorState) => EditorState) => void} apply
 * @property {(mark: Mark) => void} goTo moves the playhead to a mark
 */

export class Timeline {
  /**
   * @param {HTMLElement} place
   * @param {TimelineEditor} editor
   */
  constructor(place, editor) {
    this.place = place;
    this.editor = editor;
    this.head = shape('svg', { class: 'timeline-head', height: HEAD_HEIGHT });
    this.strip = shape('svg', { class: 'mark-strip', height: 0 });
    this.box = shape('rect', { class: 'choice-box', visibility: 'hidden' });
    this.still = shape('g');
    this.drawing = shape('svg', { class: 'track-drawing' }, this.still, this.box);
    this.side = timelineSide(editor);
    this.markNames = markNames(editor);
    this.names = jointNames(editor);
    const label = 'Joints. Up and Down select one; with Ctrl, they turn it in the selected keyframes.';
    this.tracks = element('div', { class: 'tracks', tabindex: '0', role: 'group', 'aria-label': label });
    this.tracks.append(this.names.list, this.drawing);
    this.lane = element('div', { class: 'playhead-lane' });
    this.playhead = element('div', { class: 'playhead' });
    this.fall = element('div', { class: 'fall', hidden: '' }, 'falls');
    this.lane.append(this.fall, this.playhead);
    place.append(this.side.group, this.head, this.markNames.list, this.strip, this.tracks, this.lane);
    place.tabIndex = 0;
    /** @type {EditorState | undefined} */
    this.state = undefined;
    /** @type {readonly Mark[]} */
    this.marks = [];
    /** Kinds of marks that have a row; fixed during a drag, so that nothing shifts under the pointer. */
    /** @type {ReadonlyArray<Mark['kind']>} */
    this.kinds = [];
    /** @type {Lag | undefined} */
    this.lag = undefined;
    /** Inputs of the last drawing, which is rebuilt only if they change. @type {unknown[]} */
    this.shown = [];
    this.scale = timeScale({ from: 0, span: 0 }, 0, 100);
    /** @type {import('./timeline-curves.js').AngleScale | undefined} */
    this.angles = undefined;
    this.pointer = new TimelineController(this);
    timelineKeys(this);
  }

  /** Milliseconds covered by the drawing; fixed during a drag, so that nothing shifts under the pointer. */
  get length() {
    return this.pointer.length ?? shownLength(/** @type {EditorState} */ (this.state));
  }

  /**
   * @param {EditorState} state
   * @param {readonly Mark[]} marks
   * @param {Lag | undefined} lag lag of the physical robot
   */
  draw(state, marks, lag) {
    const kinds = this.pointer.grip ? this.kinds : kindsOf(marks);
    Object.assign(this, { state, marks, lag, kinds });
    const width = this.head.clientWidth;
    this.scale = timeScale(this.pointer.view ?? state.view, this.length, width);
    const { history, chosen, rows, joint, view, layout, alone, trial, last } = state;
    const { clientHeight } = this.tracks;
    const sizes = [width, clientHeight, kinds.join()];
    const now = [history.present, chosen, rows, joint, view, layout, alone, trial, last, marks, ...sizes];
    if (now.some((each, i) => each !== this.shown[i])) {
      this.shown = now;
      this.#drawStill(state);
    }
    this.playhead.style.transform = `translateX(${this.scale.x(state.time).toFixed(1)}px)`;
  }

  /** @param {EditorState} state */
  #drawStill(state) {
    const { scale, marks, kinds } = this;
    this.head.replaceChildren(...drawRuler(scale), ...drawKeyframes(state, scale));
    this.strip.setAttribute('height', String(kinds.length * MARK_ROW));
    this.strip.replaceChildren(...drawMarks(marks, kinds, scale));
    this.#drawTracks(state);
    this.side.draw(state);
    this.names.draw(state, this.lag);
    this.markNames.draw(state, marks, kinds);
    this.#drawFall(state);
  }

  /** @param {EditorState} state */
  #drawTracks(state) {
    const isRows = state.layout === 'rows';
    this.tracks.dataset.layout = state.layout;
    const height = isRows ? state.body.joints.length * ROW : this.tracks.clientHeight;
    this.drawing.setAttribute('height', String(height));
    if (isRows) {
      this.still.replaceChildren(...drawRows(state, this.scale, this.lag));
      return;
    }
    this.angles = this.pointer.angles ?? angleScale(state, height, this.lag);
    this.still.replaceChildren(...drawCurves(state, this.scale, this.angles, this.lag));
  }

  /** @param {EditorState} state */
  #drawFall({ trial }) {
    const seconds = trial?.fallSeconds;
    this.fall.hidden = seconds === undefined;
    if (seconds !== undefined) {
      this.fall.style.transform = `translateX(${this.scale.x(1000 * seconds).toFixed(1)}px)`;
      this.fall.title = `With physics, the robot falls after ${secondsText(1000 * seconds)}`;
    }
  }

  /** Scrolls to the row of a joint. @param {number} joint */
  reveal(joint) {
    if (this.state?.layout !== 'rows') {
      return;
    }
    const top = jointRows(this.state.body).indexOf(joint) * ROW;
    const { scrollTop, clientHeight } = this.tracks;
    if (top < scrollTop || top + ROW > scrollTop + clientHeight) {
      this.tracks.scrollTop = top - clientHeight / 2;
    }
  }
}
