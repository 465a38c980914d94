/**
 * Reads the notes of a recording: log lines, which become events on the timeline, and drawings. Pure.
 *
 * @typedef {import('./recording-reader.js').RecordedEvent} RecordedEvent
 */

const CYCLES_PER_SECOND = 50;
const WARNINGS = ['WARNING', 'ERROR'];

/**
 * @param {string} lines one line of JSON per log entry and per set of drawings
 * @param {number} firstCycle cycle of the first moment of the recording
 * @returns {RecordedEvent[]} the events; incomplete lines are skipped
 */
export function notesOf(lines, firstCycle) {
  return entriesOf(lines)
    .filter(({ level }) => level !== undefined)
    .map(({ seconds, robot, level, text }) => ({
      index: Math.max(0, Math.round(seconds * CYCLES_PER_SECOND) - firstCycle),
      kind: WARNINGS.includes(level) ? /** @type {const} */ ('warning') : /** @type {const} */ ('log'),
      text: `${robot} says ${text}`,
    }));
}

/** @param {string} lines lines as in {@link notesOf} @returns {string[]} telemetry lines with drawings */
export function picturesOf(lines) {
  return entriesOf(lines).flatMap(({ drawn }) => drawn ?? []);
}

/** @param {string} lines @returns {any[]} the parsed lines; incomplete ones are skipped */
function entriesOf(lines) {
  return lines.split('\n').flatMap((line) => {
    try {
      return [JSON.parse(line)];
    } catch {
      return [];
    }
  });
}
