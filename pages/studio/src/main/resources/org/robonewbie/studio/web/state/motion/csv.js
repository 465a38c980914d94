/**
 * Motions as CSV tables: a header with column names, then a row for each keyframe. Joints may be in any order, use NAO's own names,
 * or be missing, and the separator may be a comma, semicolon or tab. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./foreign.js').Imported} Imported
 * @typedef {import('./foreign.js').Row} Row
 * @typedef {import('./foreign.js').Column} Column
 */
import {
  columnNotes,
  columnsOf,
  documentOfRows,
  numberIn,
  playedFrames,
  positiveIn,
  postureOf,
  problemNotes,
  Remarks,
  rowsOf,
  waysBetween,
  withoutEmptyEnd,
} from './foreign.js';
import { numberText } from './motion-text.js';
import { columnOf } from './webots.js';

/**
 * Time columns with durations (`isWay`) or absolute times; the first is used for export.
 *
 * @type {Array<{names: string[], millis: number, isWay: boolean}>}
 */
const TIMES = [
  { names: ['way_ms', 'millis', 'duration_ms', 'duration'], millis: 1, isWay: true },
  { names: ['time_ms', 'ms', 't_ms'], millis: 1, isWay: false },
  { names: ['time_s', 'time', 't', 'seconds', 's'], millis: 1000, isWay: false },
];

/** @param {readonly Keyframe[]} frames @param {Body} body @returns {string} table with durations in milliseconds and angles in degrees */
export function writeCsv(frames, { joints }) {
  const head = [TIMES[0].names[0], ...joints.map(({ name }) => name)].join(',');
  const rows = playedFrames(frames).map(({ millis, degrees }) => [millis, ...degrees].map(numberText).join(','));
  return [head, ...rows, ''].join('\n');
}

/**
 * @param {string} text
 * @param {Body} body
 * @param {readonly number[]} start angles of joints that the table lacks
 * @returns {Imported}
 * @throws {Error} if the header has no time or joint column, or is ambiguous; the message is meant for the user
 */
export function readCsv(text, body, start) {
  const table = tableOf(rowsOf(text));
  const { cellsOf, head, timeAt, time } = table;
  const angles = (/** @type {string[]} */ all) => all.filter((_, i) => i !== timeAt);
  const columns = columnsOf(head, angles(cellsOf(head.text)), (name) => jointColumn(name, body));
  const remarks = new Remarks();
  const wayTo = waysBetween(remarks);
  let degrees = start;
  const document = documentOfRows(table.rows, (row) => {
    if (isComment(row)) {
      return row.text.replace(/^(#|\/\/)\s*/, '');
    }
    const all = cellsOf(row.text).map(decimal);
    const given = all[timeAt] ?? '';
    const moment = time.millis * numberIn(given, `a time for ${time.names[0]}`);
    const next = postureOf(row, angles(all), 'degrees', columns, degrees, remarks);
    const way = time.isWay ? Math.round(time.millis * positiveIn(given, 'a time')) : wayTo(moment, row);
    degrees = next;
    return { millis: Math.max(1, way), degrees };
  });
  const signs = columns.names.some((name) => columnOf('nao', name))
    ? ['The columns have NAO’s joint names: angles were read as degrees with NAO’s sign conventions.']
    : [];
  return { document, notes: [...signs, ...columnNotes(columns, body), ...remarks.notes, ...problemNotes(document)] };
}

/** @param {string} text @returns {boolean} whether it starts like a motion table */
export function isTable(text) {
  try {
    return tableOf(rowsOf(text)).timeAt >= 0;
  } catch {
    return false;
  }
}

/** @param {Row[]} all */
function tableOf(all) {
  const [hint] = /^sep=(.)?$/i.exec(all[0]?.text ?? '') ?? [];
  const rows = hint === undefined ? all : all.slice(1);
  const headAt = rows.findIndex((row) => !isComment(row));
  const head = rows[headAt] ?? { text: '', number: 1 };
  const separator = hint?.slice(4) || ([';', '\t', ','].find((each) => head.text.includes(each)) ?? ',');
  const cellsOf = (/** @type {string} */ row) => cells(row, separator);
  const names = cellsOf(head.text).map(plainName);
  const timeAt = names.findIndex((name) => TIMES.some((time) => time.names.includes(name)));
  const time = TIMES.find((each) => each.names.includes(names[timeAt]));
  if (!time) {
    throw new Error(
      'This table is not a motion: its first line must name a time (way_ms, time_ms or time_s) and joints such as LEFT_KNEE_PITCH.',
    );
  }
  const isEmpty = (/** @type {Row} */ row) => withoutEmptyEnd(cellsOf(row.text)).length === 0;
  const others = rows.filter((row, i) => i !== headAt && !isEmpty(row));
  return { head, cellsOf, timeAt, time: { ...time, names: [names[timeAt]] }, rows: others };
}

/** @param {Row} row */
function isComment({ text }) {
  return /^(#|\/\/)/.test(text);
}

/** Splits a row; a quoted cell may contain the separator. @param {string} row @param {string} separator @returns {string[]} */
function cells(row, separator) {
  const found = [];
  let cell = '';
  let isQuoted = false;
  for (const sign of row) {
    isQuoted = sign === '"' ? !isQuoted : isQuoted;
    if (sign === separator && !isQuoted) {
      found.push(cell);
      cell = '';
    } else {
      cell += sign === '"' ? '' : sign;
    }
  }
  return [...found, cell].map((each) => each.trim());
}

/** @param {string} cell @returns {string} the number with a decimal point instead of a comma */
function decimal(cell) {
  return /^[^.,]*,[^.,]*$/.test(cell) ? cell.replace(',', '.') : cell;
}

/** @param {string} name */
function plainName(name) {
  return name.toLowerCase().replaceAll(/[ -]/g, '_');
}

/** @param {string} name joint name of RoboNewbie or NAO @param {Body} body @returns {Column | undefined} */
function jointColumn(name, { joints }) {
  const joint = joints.findIndex((each) => each.name.toLowerCase() === plainName(name));
  return joint < 0 ? columnOf('nao', name) : { joint, sign: 1 };
}
