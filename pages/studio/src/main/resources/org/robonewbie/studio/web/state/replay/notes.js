/**
 * Reads what is kept beside a recording: lines of logs, which become events of the time line, and what robots drew. Pure.
 *
 * @typedef {import('./recording-reader.js').RecordedEvent} RecordedEvent
 */

const CYCLES_PER_SECOND = 50;
const WARNINGS = ['WARNING', 'ERROR'];

/**
 * @param {string} lines one line of JSON for each entry of a log and for each picture
 * @param {number} firstCycle the cycle of the recording's first moment
 * @returns {RecordedEvent[]} without lines that are not finished yet
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

/** @param {string} lines as above @returns {string[]} lines of telemetry with what robots drew */
export function picturesOf(lines) {
  return entriesOf(lines).flatMap(({ drawn }) => drawn ?? []);
}

/** @param {string} lines @returns {any[]} without lines that are not finished yet */
function entriesOf(lines) {
  return lines.split('\n').flatMap((line) => {
    try {
      return [JSON.parse(line)];
    } catch {
      return [];
    }
  });
}
