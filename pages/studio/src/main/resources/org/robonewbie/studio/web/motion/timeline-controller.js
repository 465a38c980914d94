/** Pointer controller for the timeline: selects and moves keyframes, turns joints, draws a selection box, scrubs, zooms and scrolls. */
import { setAttributes } from '../panels/drawing.js';
import { moved, turnedBy } from '../state/motion/edits.js';
import { atTime, documentOf, framesOf, selected, shownLength } from '../state/motion/editor-state.js';
import { keyframesOf } from '../state/motion/motion-document.js';
import { jointName, jointRows } from '../state/motion/names.js';
import { boxed, chosenJoints, toggled, withoutRows } from '../state/motion/selection.js';
import { shownPart, zoomed } from '../state/motion/time-view.js';
import { scrolling } from './timeline-side.js';
import { secondsText, timesOf } from '../state/motion/timing.js';
import { RULER } from './timeline-head.js';
import { ROW } from './timeline-rows.js';

/**
 * @typedef {import('../state/motion/editor-state.js').EditorState} EditorState
 * @typedef {import('./timeline.js').Timeline} Timeline
 *
 * @typedef {object} Spot target under the pointer
 * @property {'ruler' | 'head' | 'mark' | 'tracks'} part
 * @property {number} x pixels from the left edge of the drawing
 * @property {number} y pixels from the top of its part
 * @property {number} time milliseconds
 * @property {number} frame index of the grabbed keyframe, or -1
 * @property {number} joint joint of the row or curve, or -1
 *
 * @typedef {object} Grip
 * @property {'scrub' | 'box' | 'time' | 'angle' | 'point'} action
 * @property {Spot} from
 * @property {import('../state/motion/motion-text.js').MotionDocument} base
 * @property {string} gesture
 * @property {boolean} all whether all visible curves are dragged, not only the one under the pointer
 */

const NEAR_PIXELS = 9;
const START_PIXELS = 4;
const ZOOM_PER_PIXEL = 0.0015;

export class TimelineController {
  /** @param {Timeline} timeline */
  constructor(timeline) {
    this.timeline = timeline;
    /** @type {Grip | undefined} */
    this.grip = undefined;
    this.gestures = 0;
    /** Milliseconds covered by the drawing, fixed during a drag. @type {number | undefined} */
    this.length = undefined;
    /** @type {import('../state/motion/time-view.js').TimeView | undefined} */
    this.view = undefined;
    /** @type {import('./timeline-curves.js').AngleScale | undefined} */
    this.angles = undefined;
    for (const part of [timeline.head, timeline.strip, timeline.drawing]) {
      /** @template {keyof SVGElementEventMap} K @param {K} type @param {(event: SVGElementEventMap[K]) => void} action */
      const listen = (type, action) =>
        part.addEventListener(type, (event) => this.timeline.state && action(event), { passive: false });
      listen('pointerdown', (event) => this.#press(event, part));
      listen('pointermove', (event) => this.#drag(event, part));
      listen('pointerup', (event) => this.#release(event, part));
      listen('pointercancel', () => this.#drop());
      listen('wheel', (event) => this.#wheel(event, part));
    }
  }

  get #state() {
    return /** @type {EditorState} */ (this.timeline.state);
  }

  /** @param {(state: EditorState) => EditorState} edit */
  #apply(edit) {
    this.timeline.editor.apply(edit);
  }

  /** @param {PointerEvent} event @param {SVGElement} part */
  #press(event, part) {
    if (event.button !== 0) {
      return;
    }
    part.setPointerCapture(event.pointerId);
    const from = this.#spot(event, part);
    const mark = /** @type {Element} */ (event.target).closest('[data-mark]');
    if (mark) {
      this.timeline.editor.goTo(this.timeline.marks[Number(mark.getAttribute('data-mark'))]);
      return;
    }
    const length = shownLength(this.#state);
    const view = shownPart(this.#state.view, length);
    const base = documentOf(this.#state);
    const all = event.shiftKey || event.ctrlKey || event.metaKey;
    this.grip = { action: actionOf(from, this.#state), from, base, gesture: `timeline ${++this.gestures}`, all };
    Object.assign(this, { length, view, angles: this.timeline.angles });
    if (from.frame >= 0) {
      this.#choose(from, event);
    } else if (this.grip.action === 'scrub') {
      this.#scrub(from);
    }
  }

  /**
   * Selects the target; an existing selection that contains it is kept, so that it can be dragged.
   *
   * @param {Spot} spot
   * @param {PointerEvent} event
   */
  #choose({ part, frame, joint }, { ctrlKey, metaKey, shiftKey }) {
    const isRow = part === 'tracks';
    this.#apply((state) => {
      const rows = isRow ? rowsWith(state, joint, ctrlKey || metaKey || shiftKey) : [];
      const withRows = isRow ? { ...state, rows, joint } : withoutRows(state);
      if (ctrlKey || metaKey) {
        return isRow && state.chosen.includes(frame) ? withRows : toggled(withRows, frame);
      }
      const isChosen = !shiftKey && state.chosen.includes(frame) && (!isRow || state.rows.includes(joint));
      const kept = isChosen ? { ...state, chosen: state.chosen } : undefined;
      const next = selected(withRows, frame, shiftKey);
      return kept ? { ...next, first: kept.first, chosen: kept.chosen, rows: kept.rows } : next;
    });
  }

  /** @param {PointerEvent} event @param {SVGElement} part */
  #drag(event, part) {
    const { grip } = this;
    const spot = this.#spot(event, part);
    if (!grip) {
      this.#explain(spot, part);
    } else if (framesOf(this.#state).length !== keyframesOf(grip.base).length) {
      this.#drop(); // A key press has changed the motion during the drag.
    } else if (grip.action === 'scrub') {
      this.#scrub(spot);
    } else if (Math.hypot(spot.x - grip.from.x, spot.y - grip.from.y) > START_PIXELS || this.#isMoving) {
      if (grip.action === 'point') {
        grip.action = Math.abs(spot.y - grip.from.y) > Math.abs(spot.x - grip.from.x) ? 'angle' : 'time';
      }
      this.#isMoving = true;
      this.#pull(grip, spot, event.altKey);
    }
  }

  #isMoving = false;

  /** @param {Grip} grip @param {Spot} spot @param {boolean} alt */
  #pull({ action, from, base, gesture, all }, spot, alt) {
    if (action === 'time') {
      const by = (spot.x - from.x) / this.timeline.scale.perMilli;
      this.#apply((state) => moved(state, by, { alone: alt !== state.alone, base, gesture }));
    } else if (action === 'angle' && this.angles) {
      const by = Math.round(10 * (this.angles.degrees(spot.y) - this.angles.degrees(from.y))) / 10;
      this.#apply((state) => turnedBy(state, all ? chosenJoints(state) : [from.joint], by, { base, gesture }));
    } else if (action === 'box') {
      this.#drawBox(from, spot);
    }
  }

  /** @param {PointerEvent} event @param {SVGElement} part */
  #release(event, part) {
    const { grip } = this;
    const spot = this.#spot(event, part);
    const adds = event.ctrlKey || event.metaKey || event.shiftKey;
    const hasMoved = this.#isMoving;
    this.#drop();
    if (grip?.action === 'box' && hasMoved) {
      this.#apply((state) => boxed(state, this.#boxOf(grip.from, spot), adds));
    } else if (grip?.action === 'box') {
      this.#scrub(grip.from);
      this.#apply((state) => (grip.from.joint < 0 ? state : { ...state, joint: grip.from.joint, rows: [] }));
    } else if (grip && grip.from.frame >= 0 && !hasMoved && !adds) {
      const { frame, joint, part: where } = grip.from;
      this.#apply((state) => {
        const rows = where !== 'tracks' ? [] : state.layout === 'rows' ? [joint] : state.rows;
        return { ...selected(state, frame), rows };
      });
    }
  }

  #drop() {
    this.grip = undefined;
    this.#isMoving = false;
    this.timeline.box.setAttribute('visibility', 'hidden');
    Object.assign(this, { length: undefined, view: undefined, angles: undefined });
    this.#apply((state) => ({ ...state }));
  }

  /** @param {Spot} spot */
  #scrub({ time }) {
    this.#apply((state) => ({ ...atTime(state, time), playing: false }));
  }

  /** @param {WheelEvent} event @param {SVGElement} part */
  #wheel(event, part) {
    const isSideways = event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY);
    const isForRows = part === this.timeline.drawing && this.#state.layout === 'rows';
    if (isForRows && !isSideways && !event.ctrlKey && !event.metaKey && !event.altKey) {
      return;
    }
    event.preventDefault();
    const delta = event.deltaY || event.deltaX;
    const { time } = this.#spot(event, part);
    this.#apply(
      isSideways
        ? scrolling((isSideways && event.deltaX ? event.deltaX : delta) / Math.max(1, this.timeline.scale.width))
        : (state) => ({
            ...state,
            view: zoomed(state.view, shownLength(state), Math.exp(ZOOM_PER_PIXEL * delta), time),
          }),
    );
  }

  /** @param {MouseEvent} event @param {SVGElement} part @returns {Spot} */
  #spot(event, part) {
    const { timeline } = this;
    const box = part.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const time = timeline.scale.time(x);
    if (part === timeline.head) {
      return {
        part: y < RULER ? 'ruler' : 'head',
        x,
        y,
        time,
        frame: y < RULER ? -1 : this.#frameAt(x, 15),
        joint: -1,
      };
    }
    if (part === timeline.strip) {
      return { part: 'mark', x, y, time, frame: -1, joint: -1 };
    }
    const { frame, joint } = this.#state.layout === 'rows' ? this.#cellAt(x, y) : this.#pointAt(x, y);
    return { part: 'tracks', x, y, time, frame, joint };
  }

  /** @param {number} x @param {number} reach pixels @returns {number} the nearest keyframe, or -1 */
  #frameAt(x, reach) {
    const ways = timesOf(framesOf(this.#state)).map((time) => Math.abs(this.timeline.scale.x(time) - x));
    const nearest = Math.min(Infinity, ...ways);
    return nearest <= reach ? ways.indexOf(nearest) : -1;
  }

  /** @param {number} x @param {number} y */
  #cellAt(x, y) {
    return { frame: this.#frameAt(x, NEAR_PIXELS), joint: jointRows(this.#state.body)[Math.floor(y / ROW)] ?? -1 };
  }

  /** @param {number} x @param {number} y */
  #pointAt(x, y) {
    const angles = this.angles ?? this.timeline.angles;
    const frames = framesOf(this.#state);
    const points = timesOf(frames).flatMap((time, frame) =>
      chosenJoints(this.#state).map((joint) => ({
        frame,
        joint,
        way: Math.hypot(this.timeline.scale.x(time) - x, (angles?.y(frames[frame].degrees[joint]) ?? 0) - y),
      })),
    );
    const nearest = points.sort((a, b) => a.way - b.way)[0];
    return nearest && nearest.way <= NEAR_PIXELS ? nearest : { frame: -1, joint: -1 };
  }

  /** @param {Spot} from @param {Spot} to */
  #drawBox(from, to) {
    const { box } = this.timeline;
    const sizes = { x: Math.min(from.x, to.x), y: Math.min(from.y, to.y) };
    const edges = { width: Math.abs(to.x - from.x), height: Math.abs(to.y - from.y) };
    setAttributes(box, { ...sizes, ...edges, visibility: 'visible' });
  }

  /** @param {Spot} one @param {Spot} other @returns {import('../state/motion/selection.js').Box} */
  #boxOf(one, other) {
    const [top, bottom] = [Math.min(one.y, other.y), Math.max(one.y, other.y)];
    const span = { from: Math.min(one.time, other.time), to: Math.max(one.time, other.time) };
    const { angles } = this.timeline;
    if (this.#state.layout === 'curves' && angles) {
      return { ...span, low: angles.degrees(bottom), high: angles.degrees(top) };
    }
    const order = jointRows(this.#state.body);
    return { ...span, rows: order.slice(Math.max(0, Math.floor(top / ROW)), Math.floor(bottom / ROW) + 1) };
  }

  /** Describes the target under the pointer. @param {Spot} spot @param {SVGElement} part */
  #explain({ frame, joint }, part) {
    if (part !== this.timeline.drawing) {
      return;
    }
    part.style.cursor = frame >= 0 ? 'grab' : 'crosshair';
    const { body } = this.#state;
    const degrees = framesOf(this.#state)[frame]?.degrees[joint];
    const time = timesOf(framesOf(this.#state))[frame];
    const text =
      degrees === undefined
        ? 'Drag to select several; click to move the playhead'
        : `${jointName(body.joints[joint].name)} ${degrees}° in keyframe ${frame + 1} at ${secondsText(time)}`;
    this.timeline.tracks.title = text;
  }
}

/** @param {Spot} spot @param {EditorState} state @returns {Grip['action']} */
function actionOf({ part, frame }, { layout }) {
  if (part === 'tracks') {
    return frame < 0 ? 'box' : layout === 'rows' ? 'time' : 'point';
  }
  return frame < 0 ? 'scrub' : 'time';
}

/** @param {EditorState} state @param {number} joint @param {boolean} adds */
function rowsWith({ rows }, joint, adds) {
  return adds || rows.includes(joint) ? [...new Set([...rows, joint])] : [joint];
}
