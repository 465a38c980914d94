/** The left column of the timeline: buttons, names of marks, names of joints. */
import { button, check, element, setText } from '../panels/elements.js';
import { nextMark } from '../state/motion/marks.js';
import { jointName, jointRows } from '../state/motion/names.js';
import { withRow } from '../state/motion/selection.js';
import { shownLength } from '../state/motion/editor-state.js';
import { scrolled, WHOLE, zoomed } from '../state/motion/time-view.js';
import { curveColour } from './timeline-curves.js';
import { MARK_KINDS } from './timeline-head.js';

/**
 * @typedef {import('../state/motion/editor-state.js').EditorState} EditorState
 * @typedef {import('../state/motion/checks.js').Mark} Mark
 * @typedef {import('../state/motion/lag.js').Lag} Lag
 * @typedef {import('./timeline.js').TimelineEditor} TimelineEditor
 */

const CLOSER = 0.6;
const SCROLL = 0.5;
const ALONE_HINT =
  'Moving a keyframe also moves all later ones. With this option, or while Alt is pressed, the others stay in place.';

/** @param {number} factor @returns {(state: EditorState) => EditorState} zooms around the playhead */
export function zooming(factor) {
  return (state) => ({ ...state, view: zoomed(state.view, shownLength(state), factor, state.time) });
}

/** @param {number} share @returns {(state: EditorState) => EditorState} */
export function scrolling(share) {
  return (state) => ({ ...state, view: scrolled(state.view, shownLength(state), share) });
}

/** @param {EditorState} state @returns {EditorState} */
export function withWholeView(state) {
  return { ...state, view: WHOLE };
}

/** @param {TimelineEditor} editor */
export function timelineSide(editor) {
  const does = (/** @type {(state: EditorState) => EditorState} */ edit) => () => editor.apply(edit);
  const layout = (/** @type {EditorState['layout']} */ each) => does((state) => ({ ...state, layout: each }));
  const rows = button('Joints', 'One row for each joint (R)', layout('rows'), { id: 'timeline-rows' });
  const curves = button('Curves', 'Angles of the selected joints (R)', layout('curves'), { id: 'timeline-curves' });
  const alone = check('alone', 'Move alone', ALONE_HINT, (on) => editor.apply((state) => ({ ...state, alone: on })));
  const views = [
    button('−', 'Zoom out (−)', does(zooming(1 / CLOSER)), { id: 'zoom-out' }),
    button('+', 'Zoom in (+)', does(zooming(CLOSER)), { id: 'zoom-in' }),
    button('All', 'Show the whole motion (0)', does(withWholeView), { id: 'zoom-all' }),
    button('◂', 'Scroll left (Page up)', does(scrolling(-SCROLL)), { id: 'scroll-earlier' }),
    button('▸', 'Scroll right (Page down)', does(scrolling(SCROLL)), { id: 'scroll-later' }),
  ];
  const group = element(
    'div',
    { class: 'timeline-side' },
    element('div', { class: 'group' }, rows, curves, alone.label),
    element('div', { class: 'group' }, ...views),
  );
  return {
    group,
    /** @param {EditorState} state */
    draw(state) {
      rows.setAttribute('aria-pressed', String(state.layout === 'rows'));
      curves.setAttribute('aria-pressed', String(state.layout === 'curves'));
      alone.box.checked = state.alone;
      const isWhole = state.view.span === 0;
      for (const index of [0, 2, 3, 4]) {
        views[index].disabled = isWhole;
      }
    },
  };
}

/** @param {TimelineEditor} editor */
export function markNames(editor) {
  const list = element('div', { class: 'mark-names' });
  /** @type {{state?: EditorState, marks: readonly Mark[]}} */
  const now = { marks: [] };
  const buttons = MARK_KINDS.map(({ kind, name, meaning }) => {
    const made = button(name, `${meaning} Click to go to the next one (W)`, () => {
      const next =
        now.state &&
        nextMark(
          now.marks.filter((mark) => mark.kind === kind),
          now.state.time,
        );
      if (next) {
        editor.goTo(next);
      }
    });
    made.dataset.kind = kind;
    list.append(made);
    return { kind, name, made };
  });
  return {
    list,
    /** @param {EditorState} state @param {readonly Mark[]} marks @param {ReadonlyArray<Mark['kind']>} present */
    draw(state, marks, present) {
      Object.assign(now, { state, marks });
      for (const { kind, name, made } of buttons) {
        made.hidden = !present.includes(kind);
        setText(made, `${name} ${marks.filter((mark) => mark.kind === kind).length}`);
      }
    },
  };
}

/** @param {TimelineEditor} editor */
export function jointNames(editor) {
  const list = element('div', { class: 'track-names', 'aria-hidden': 'true' });
  /** @type {EditorState['body'] | undefined} */
  let shownBody;
  /** @type {ReturnType<typeof rowOf>[]} */
  let rows = [];
  /** @param {EditorState['body']} body @param {number} joint */
  const rowOf = (body, joint) => {
    const swatch = element('span', { class: 'swatch' });
    const value = element('span', { class: 'late-degrees' });
    const line = element('div', { class: 'track-name' }, swatch, jointName(body.joints[joint].name), value);
    line.dataset.row = String(joint);
    line.addEventListener('click', (event) => {
      const manner = event.ctrlKey || event.metaKey || event.shiftKey ? 'toggle' : 'only';
      editor.apply((state) => withRow(state, joint, manner));
    });
    return { joint, line, swatch, value };
  };
  return {
    list,
    /** @param {EditorState} state @param {Lag | undefined} lag */
    draw(state, lag) {
      if (state.body !== shownBody) {
        shownBody = state.body;
        rows = jointRows(state.body).map((joint) => rowOf(state.body, joint));
        list.replaceChildren(...rows.map(({ line }) => line));
      }
      const shown = state.rows.length > 0 ? state.rows : [state.joint];
      for (const { joint, line, swatch, value } of rows) {
        line.classList.toggle('chosen', shown.includes(joint));
        swatch.className =
          shown.includes(joint) && state.layout === 'curves' ? `swatch ${curveColour(state, joint)}` : 'swatch';
        setText(value, lag && lag.worst[joint].degrees >= 1 ? `${lag.worst[joint].degrees.toFixed(0)}°` : '');
        line.title = lag ? lateText(lag, joint) : 'Click to select; Ctrl-click to select several';
      }
    },
  };
}

/** @param {Lag} lag @param {number} joint */
function lateText({ worst }, joint) {
  const { degrees, time } = worst[joint];
  return `With physics, the joint lags by at most ${degrees.toFixed(1)}°, at ${(time / 1000).toFixed(2)} s`;
}
