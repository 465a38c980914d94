/**
 * Motions as tables for spreadsheets and scripts: a head line with names, then a row for each keyframe. Joints may come in any
 * order, some may be missing, and the cells may be parted by commas, semicolons or tabs. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./foreign.js').Imported} Imported
 */
import { documentOfRows, fourDecimals, numberIn, problemNotes, rowsOf, waysBetween } from './foreign.js';
import { numberText } from './motion-text.js';

/** The first is what we write. @type {Array<{names: string[], millis: number, isWay: boolean}>} */
const TIMES = [
  { names: ['way_ms', 'millis', 'duration_ms', 'duration'], millis: 1, isWay: true },
  { names: ['time_ms', 'ms', 't_ms'], millis: 1, isWay: false },
  { names: ['time_s', 'time', 't', 'seconds', 's'], millis: 1000, isWay: false },
];

/** @param {readonly Keyframe[]} frames @param {Body} body @returns {string} ways in milliseconds, angles in degrees */
export function writeCsv(frames, { joints }) {
  const head = [TIMES[0].names[0], ...joints.map(({ name }) => name)].join(',');
  const rows = frames.map(({ millis, degrees }) => [millis, ...degrees].map(numberText).join(','));
  return [head, ...rows, ''].join('\n');
}

/**
 * @param {string} text
 * @param {Body} body
 * @param {readonly number[]} start angles of joints of which the table says nothing
 * @returns {Imported}
 * @throws {Error} if the head line names no time or no joint; the message is meant for people
 */
export function readCsv(text, { joints }, start) {
  const [head, ...rows] = rowsOf(text);
  const separator = [';', '\t', ','].find((each) => head?.text.includes(each)) ?? ',';
  const cellsOf = (/** @type {string} */ row) =>
    row.split(separator).map((cell) => cell.trim().replace(/^"(.*)"$/, '$1'));
  const names = cellsOf(head?.text ?? '').map((name) => name.toLowerCase().replaceAll(/[ -]/g, '_'));
  const columns = names.map((name) => joints.findIndex((joint) => joint.name.toLowerCase() === name));
  const timeAt = names.findIndex((name) => TIMES.some((time) => time.names.includes(name)));
  const time = TIMES.find((each) => each.names.includes(names[timeAt]));
  if (!time || columns.every((joint) => joint < 0)) {
    throw new Error(
      'This table is no motion: its first line must name a time (way_ms, time_ms or time_s) and joints such as LEFT_KNEE_PITCH.',
    );
  }
  const wayTo = waysBetween();
  let degrees = start;
  const document = documentOfRows(rows, (row) => {
    if (/^(#|\/\/)/.test(row.text)) {
      return row.text.replace(/^(#|\/\/)\s*/, '');
    }
    const cells = cellsOf(row.text).map((cell) => (separator === ',' ? cell : cell.replace(',', '.')));
    const millis = time.millis * numberIn(cells[timeAt] ?? '', `a time for ${names[timeAt]}`);
    const next = [...degrees];
    columns.forEach((joint, i) => {
      if (joint >= 0 && (cells[i] ?? '') !== '') {
        next[joint] = fourDecimals(numberIn(cells[i], 'an angle in degrees, such as -12.5'));
      }
    });
    degrees = next;
    return { millis: time.isWay ? Math.round(millis) : wayTo(millis), degrees };
  });
  return { document, notes: [...columnNotes(names, columns, timeAt), ...problemNotes(document)] };
}

/** @param {string[]} names @param {number[]} columns @param {number} timeAt */
function columnNotes(names, columns, timeAt) {
  const unknown = names.filter((name, i) => i !== timeAt && columns[i] < 0 && name !== '');
  return unknown.length > 0 ? [`Columns that are no joints were left out: ${unknown.join(', ')}.`] : [];
}
