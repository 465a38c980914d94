/** Plays the motion on a physically simulated robot and shows the result. */
import { atTime, documentOf } from '../state/motion/editor-state.js';
import { jointName } from '../state/motion/names.js';
import { secondsText } from '../state/motion/timing.js';

/** @typedef {import('./editor.js').Editor} Editor */

/** Minimum lag to report, in degrees; smaller lags are not visible. */
const KEPT_DEGREES = 1;

/** @param {Editor} editor @param {string} start standing, back or front */
export async function tryPhysically(editor, start) {
  const { files, listener } = editor;
  editor.busy = true;
  listener.changed();
  try {
    const document = documentOf(editor.state);
    const trial = await files.trial(document, start);
    if (documentOf(editor.state) !== document) {
      listener.note('The motion was changed during the trial. Try again.');
      return;
    }
    editor.set({ ...atTime({ ...editor.state, trial, watching: true }, 0), playing: true });
    listener.note([start === 'standing' ? fallText(trial.fallSeconds) : '', lagText(editor)].filter(Boolean).join(' '));
  } finally {
    editor.busy = false;
    listener.changed();
  }
}

/** @param {number | undefined} seconds */
function fallText(seconds) {
  return seconds === undefined
    ? 'The robot stays on its feet.'
    : `The robot falls after ${secondsText(1000 * seconds)}.`;
}

/** @param {Editor} editor @returns {string} sentence about the joint with the largest lag */
function lagText({ lag, state }) {
  if (!lag || lag.joint < 0) {
    return '';
  }
  const { degrees, time } = lag.worst[lag.joint];
  if (degrees < KEPT_DEGREES) {
    return 'All joints follow the plan.';
  }
  return `Largest lag behind the plan: ${jointName(state.body.joints[lag.joint].name)}, ${degrees.toFixed(0)}° at ${secondsText(time)}.`;
}
