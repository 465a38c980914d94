/**
 * Immutable state of the motion editor. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./motion-text.js').MotionDocument} MotionDocument
 *
 * @typedef {object} Trial result of a trial on a physically simulated robot
 * @property {number} frameSeconds
 * @property {number} [fallSeconds]
 * @property {number[][]} frames the torso's pose and the angles of the model's hinges, per frame
 *
 * @typedef {object} EditorState
 * @property {Body} body
 * @property {string} name file name, empty for an untitled motion
 * @property {string} draft draft name of an untitled motion, empty without a draft
 * @property {string} version version of the file on the disk, empty if it does not exist
 * @property {MotionDocument} saved document on the disk or in the library
 * @property {import('./history.js').History<MotionDocument>} history
 * @property {number} first anchor of a range selection
 * @property {number} last the most recently selected keyframe, at the playhead
 * @property {readonly number[]} chosen all selected keyframes
 * @property {readonly number[]} rows the selected joints of these keyframes, empty for all
 * @property {number} time time of the playhead, milliseconds
 * @property {boolean} playing
 * @property {boolean} looping
 * @property {number} speed playback speed, 1 for real time
 * @property {boolean} symmetric whether edits are mirrored to the other side
 * @property {'upright' | 'soles'} manner how the robot is placed on the ground
 * @property {boolean} ghosts whether the neighbouring keyframes are shown too
 * @property {number} joint joint whose curve is shown
 * @property {number[]} start posture before the motion
 * @property {Trial | undefined} trial
 * @property {boolean} watching whether the robot of the trial is shown rather than the plan
 * @property {boolean} alone whether moving keyframes leaves later ones in place
 * @property {'rows' | 'curves'} layout layout of the timeline
 * @property {import('./time-view.js').TimeView} view the part of the motion that the timeline shows
 */
import { changed, historyOf, redone, undone } from './history.js';
import { keyframesOf, wholeCycles, withInserted, withKeyframe } from './motion-document.js';
import { EMPTY_DOCUMENT, textOf } from './motion-text.js';
import { revealing, WHOLE } from './time-view.js';
import { durationOf, keyframeAt, postureAt, timesOf } from './timing.js';
import { symmetric } from './posture.js';
import { stanceOf } from './poses.js';

const NEW_WAY_MILLIS = 500;

/**
 * @param {Body} body
 * @returns {EditorState}
 */
export function initialEditor(body) {
  return {
    body,
    name: '',
    draft: '',
    version: '',
    saved: EMPTY_DOCUMENT,
    history: historyOf(EMPTY_DOCUMENT),
    first: 0,
    last: 0,
    chosen: [0],
    rows: [],
    time: 0,
    playing: false,
    looping: false,
    speed: 1,
    symmetric: false,
    manner: 'soles',
    ghosts: true,
    joint: 0,
    start: stanceOf(body),
    trial: undefined,
    watching: false,
    alone: false,
    layout: 'rows',
    view: WHOLE,
  };
}

/** @param {EditorState} state @returns {MotionDocument} */
export function documentOf(state) {
  return state.history.present.value;
}

/** @param {EditorState} state @returns {Keyframe[]} */
export function framesOf(state) {
  return keyframesOf(documentOf(state));
}

/** @param {EditorState} state @returns {boolean} whether there are unsaved changes */
export function isUnsaved(state) {
  return textOf(documentOf(state)) !== textOf(state.saved);
}

/** @param {EditorState} state @returns {number} milliseconds */
export function lengthOf(state) {
  return durationOf(framesOf(state));
}

/**
 * @typedef {object} OpenedFile
 * @property {string} name
 * @property {string} [draft]
 * @property {string} version
 * @property {Body} [body] the robot that the motion is for, unless it is that of the last motion
 * @property {MotionDocument} document
 * @property {MotionDocument} [recovered] unsaved work
 *
 * @param {EditorState} state
 * @param {OpenedFile} file
 * @returns {EditorState}
 */
export function withFile(state, { name, draft = '', version, body = state.body, document, recovered }) {
  const history = historyOf(document);
  const opened = {
    ...(body === state.body ? state : { ...state, body, start: stanceOf(body), joint: 0, symmetric: false }),
    name,
    draft,
    version,
    saved: name === '' ? EMPTY_DOCUMENT : document,
    history: recovered ? changed(history, recovered, 'Recover unsaved work') : history,
    playing: false,
    trial: undefined,
    watching: false,
    rows: [],
    view: WHOLE,
  };
  return selected(opened, 0);
}

/**
 * @param {EditorState} state
 * @param {string} name
 * @param {string} version
 * @param {MotionDocument} document document that was saved
 * @returns {EditorState}
 */
export function withSaved(state, name, version, document) {
  return { ...state, name, draft: '', version, saved: document };
}

/**
 * Selects keyframes; the playhead moves to the last one.
 *
 * @param {EditorState} state
 * @param {number} index
 * @param {boolean} [extending] whether those in between are selected too
 * @returns {EditorState}
 */
export function selected(state, index, extending = false) {
  const frames = framesOf(state);
  const last = Math.max(0, Math.min(frames.length - 1, index));
  const first = extending ? state.first : last;
  const from = Math.min(first, last);
  const chosen = Array.from({ length: Math.abs(first - last) + 1 }, (_, i) => from + i);
  const time = timesOf(frames)[last] ?? 0;
  const view = revealing(state.view, shownLength(state), time);
  return { ...state, first, last, chosen, time, view, playing: false, watching: false };
}

/** @param {EditorState} state @returns {[number, number]} the first and the last selected keyframe */
export function selectionOf({ chosen }) {
  return [Math.min(...chosen), Math.max(...chosen)];
}

/**
 * @param {EditorState} state
 * @param {number} time milliseconds
 * @returns {EditorState}
 */
export function atTime(state, time) {
  const limited = Math.max(0, Math.min(playableLength(state), time));
  const index = Math.max(0, keyframeAt(framesOf(state), limited));
  const chosen = index === state.last && state.chosen.length === 1 ? state.chosen : [index];
  const view = state.playing ? revealing(state.view, shownLength(state), limited) : state.view;
  return { ...state, time: limited, first: index, last: index, chosen, view };
}

/** @param {EditorState} state @returns {number} milliseconds that the timeline must cover */
export function shownLength(state) {
  return Math.max(lengthOf(state), playableLength({ ...state, watching: true }));
}

/** @param {EditorState} state @returns {number} milliseconds of the motion, or of the trial if it is shown */
export function playableLength(state) {
  const { trial, watching } = state;
  return trial && watching ? (trial.frames.length - 1) * trial.frameSeconds * 1000 : lengthOf(state);
}

/**
 * @param {EditorState} state
 * @param {number} millis elapsed time
 * @returns {EditorState}
 */
export function played(state, millis) {
  const length = playableLength(state);
  const time = state.time + millis * state.speed;
  if (time < length) {
    return atTime(state, time);
  }
  return state.looping && length > 0 ? atTime(state, time % length) : { ...atTime(state, length), playing: false };
}

/** @param {EditorState} state @returns {boolean} whether the playhead is at the last selected keyframe */
export function isOnKeyframe(state) {
  const time = timesOf(framesOf(state))[state.last];
  return time !== undefined && Math.abs(time - state.time) < 1;
}

/** @param {EditorState} state @returns {readonly number[]} the posture at the playhead */
export function postureNow(state) {
  const frames = framesOf(state);
  return isOnKeyframe(state) ? frames[state.last].degrees : postureAt(frames, state.start, state.time);
}

/**
 * Adds an undo step; a change without effect adds none, so that each undo has a visible effect.
 *
 * @param {EditorState} state
 * @param {MotionDocument} document
 * @param {string} label text for the undo button
 * @param {string} [gesture] changes of one gesture form one undo step
 * @returns {EditorState}
 */
export function edited(state, document, label, gesture = '') {
  if (textOf(document) === textOf(documentOf(state))) {
    return state;
  }
  const history = changed(state.history, document, label, gesture);
  return { ...state, history, trial: undefined, watching: false, playing: false };
}

/** @param {EditorState} state @returns {EditorState} */
export function withUndo(state) {
  return withChangeShown(state, undone(state.history));
}

/** @param {EditorState} state @returns {EditorState} */
export function withRedo(state) {
  return withChangeShown(state, redone(state.history));
}

/**
 * Selects the first keyframe that undo or redo has changed, so that its effect is visible.
 *
 * @param {EditorState} state
 * @param {EditorState['history']} history
 */
function withChangeShown(state, history) {
  const before = framesOf(state);
  const next = { ...state, history, trial: undefined, watching: false };
  const changedAt = framesOf(next).findIndex((frame, i) => !isSameKeyframe(frame, before[i]));
  return selected(next, changedAt < 0 ? state.last : changedAt);
}

/** @param {Keyframe} one @param {Keyframe | undefined} other */
function isSameKeyframe(one, other) {
  return one.millis === other?.millis && one.degrees.every((angle, joint) => angle === other.degrees[joint]);
}

/**
 * Sets the posture of the keyframe at the playhead; inserts a keyframe if there is none.
 *
 * @param {EditorState} state
 * @param {readonly number[]} posture
 * @param {string} label
 * @param {string} [gesture]
 * @returns {EditorState}
 */
export function posed(state, posture, label, gesture = '') {
  const target = isOnKeyframe(state) ? state : withKeyframeHere(state, gesture);
  const before = framesOf(target)[target.last].degrees;
  const degrees = state.symmetric ? symmetric(state.body, before, posture) : [...posture];
  return edited(target, withKeyframe(documentOf(target), target.last, { degrees }), label, gesture);
}

/**
 * Inserts a keyframe at the playhead, or after the selected one if the playhead is at it.
 *
 * @param {EditorState} state
 * @param {string} [gesture]
 * @returns {EditorState}
 */
export function withKeyframeHere(state, gesture = '') {
  const frames = framesOf(state);
  const times = timesOf(frames);
  const length = times.at(-1) ?? 0;
  const next = times.findIndex((time) => state.time < time - 1);
  if (next < 0 || isOnKeyframe(state)) {
    const at = frames.length === 0 || state.time >= length ? frames.length : state.last + 1;
    const posture = { millis: NEW_WAY_MILLIS, degrees: postureNow(state) };
    return selected(edited(state, withInserted(documentOf(state), at, posture), 'Insert keyframe', gesture), at);
  }
  const way = wholeCycles(state.time - (times[next - 1] ?? 0));
  const rest = Math.max(0, frames[next].millis - way);
  const shortened = withKeyframe(documentOf(state), next, { millis: Math.max(20, rest) });
  const inserted = withInserted(shortened, next, { millis: way, degrees: postureNow(state) });
  return selected(edited(state, inserted, 'Insert keyframe', gesture), next);
}
