/** Keyboard actions while the timeline has the focus. */
import { moved, turnedBy } from '../state/motion/edits.js';
import { framesOf, selected } from '../state/motion/editor-state.js';
import { jointRows } from '../state/motion/names.js';
import { chosenJoints, withoutRows, withOneChosen, withRow } from '../state/motion/selection.js';
import { scrolling, withWholeView, zooming } from './timeline-side.js';

/** @typedef {import('../state/motion/editor-state.js').EditorState} EditorState */

const FINE_MILLIS = 20;
const COARSE_MILLIS = 100;

/** @param {import('./timeline.js').Timeline} timeline */
export function timelineKeys(timeline) {
  timeline.place.addEventListener('keydown', (event) => {
    const target = /** @type {HTMLElement} */ (event.target);
    const edit = target === timeline.place || target === timeline.tracks ? editOf(event) : undefined;
    if (edit) {
      event.preventDefault();
      event.stopPropagation();
      timeline.editor.apply(edit);
      timeline.reveal(timeline.state?.joint ?? 0);
    }
  });
}

/** @param {KeyboardEvent} event @returns {((state: EditorState) => EditorState) | undefined} */
function editOf(event) {
  const { key } = event;
  if (key === 'ArrowLeft' || key === 'ArrowRight') {
    return alongTime(event, key === 'ArrowLeft' ? -1 : 1);
  }
  if (key === 'ArrowUp' || key === 'ArrowDown') {
    return alongJoints(event, key === 'ArrowUp' ? -1 : 1);
  }
  return event.ctrlKey || event.metaKey || event.altKey ? undefined : VIEWS[key];
}

/** @type {Record<string, (state: EditorState) => EditorState>} */
const VIEWS = {
  '+': zooming(0.6),
  '=': zooming(0.6),
  '-': zooming(1 / 0.6),
  0: withWholeView,
  PageUp: scrolling(-0.5),
  PageDown: scrolling(0.5),
  Home: (state) => selected(state, 0),
  End: (state) => selected(state, framesOf(state).length - 1),
  Escape: (state) => withOneChosen(state),
};

/** @param {KeyboardEvent} event @param {-1 | 1} way @returns {(state: EditorState) => EditorState} */
function alongTime({ ctrlKey, metaKey, altKey, shiftKey }, way) {
  if (ctrlKey || metaKey || altKey) {
    const by = way * (shiftKey ? COARSE_MILLIS : FINE_MILLIS);
    return (state) => moved(state, by, { alone: altKey || state.alone });
  }
  return (state) => selected(state, state.last + way, shiftKey);
}

/** @param {KeyboardEvent} event @param {-1 | 1} way @returns {(state: EditorState) => EditorState} */
function alongJoints({ ctrlKey, metaKey, shiftKey }, way) {
  if (ctrlKey || metaKey) {
    return (state) => turnedBy(state, chosenJoints(state), -way * (shiftKey ? 10 : 1));
  }
  return (state) => {
    const order = jointRows(state.body);
    const at = order.indexOf(state.joint) + (state.rows.length === 0 ? 0 : way);
    const joint = order[Math.max(0, Math.min(order.length - 1, at))];
    if (!shiftKey) {
      return withRow(state, joint);
    }
    return { ...withoutRows(state), joint, rows: [...new Set([...state.rows, state.joint, joint])] };
  };
}
