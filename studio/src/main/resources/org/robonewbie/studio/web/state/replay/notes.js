/**
 * Makes events of the time line from what robots wrote into their logs. Pure.
 *
 * @typedef {import('./recording-reader.js').RecordedEvent} RecordedEvent
 */

const CYCLES_PER_SECOND = 50;
const WARNINGS = ['WARNING', 'ERROR'];

/**
 * @param {string} lines one line of JSON for each entry of a log
 * @param {number} firstCycle the cycle of the recording's first moment
 * @returns {RecordedEvent[]} without lines that are not finished yet
 */
export function notesOf(lines, firstCycle) {
  return lines.split('\n').flatMap((line) => {
    try {
      const { seconds, robot, level, text } = JSON.parse(line);
      const index = Math.max(0, Math.round(seconds * CYCLES_PER_SECOND) - firstCycle);
      return [
        {
          index,
          kind: WARNINGS.includes(level) ? /** @type {const} */ ('warning') : /** @type {const} */ ('log'),
          text: `${robot} says ${text}`,
        },
      ];
    } catch {
      return [];
    }
  });
}
