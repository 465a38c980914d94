/**
 * Code shared by the readers of other programs' motion files: rows become keyframes, and an unreadable row is kept verbatim with its line
 * number. Counts are verified, so that no angle is assigned to the wrong joint. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./motion-text.js').Line} Line
 * @typedef {import('./motion-text.js').MotionDocument} MotionDocument
 *
 * @typedef {object} Imported
 * @property {MotionDocument} document
 * @property {string[]} notes remarks for the user about the import
 *
 * @typedef {object} Row of a foreign file
 * @property {string} text
 * @property {number} number line number, starting at 1
 *
 * @typedef {object} Columns
 * @property {string[]} names names of all angle columns, as written
 * @property {Array<Column | undefined>} columns joint of each column; undefined for joints that this robot lacks
 *
 * @typedef {object} Column
 * @property {number} joint index in the order of the motion files
 * @property {number} sign 1, or -1 if the other program uses the opposite sign
 */
import { fourDecimals } from '../numbers.js';
import { EMPTY_DOCUMENT, newLine } from './motion-text.js';

const MIN_WAY = 20;

/** Thrown for an unreadable row; the message states what was found and what was expected. */
export class UnreadableRow extends Error {}

/** @param {string} text @returns {Row[]} the non-empty rows */
export function rowsOf(text) {
  return text
    .replace(/^\uFEFF/, '')
    .split(/\r\n|\r|\n/)
    .map((row, i) => ({ text: row.trim(), number: i + 1 }))
    .filter((row) => row.text !== '');
}

/**
 * @param {readonly Row[]} rows
 * @param {(row: Row) => Keyframe | string} read returns a keyframe or a comment; throws {@link UnreadableRow}
 * @returns {MotionDocument}
 */
export function documentOfRows(rows, read) {
  return { ...EMPTY_DOCUMENT, lines: rows.map((row) => lineOf(row, read)) };
}

/** @param {Row} row @param {(row: Row) => Keyframe | string} read @returns {Line} */
function lineOf(row, read) {
  try {
    const found = read(row);
    return typeof found === 'string' ? { text: `// ${found}`, end: '\n' } : newLine(found, '\n');
  } catch (error) {
    if (error instanceof UnreadableRow) {
      return { text: row.text, end: '\n', problem: `line ${row.number} of the file: ${error.message}` };
    }
    throw error;
  }
}

/** @param {MotionDocument} document @returns {string[]} remark about the first unreadable line and the number of such lines */
export function problemNotes({ lines }) {
  const problems = lines.flatMap(({ problem }) => (problem ? [problem] : []));
  if (problems.length === 0) {
    return [];
  }
  const others = problems.length > 1 ? `, and ${problems.length - 1} more` : '';
  return [`Skipped and kept unchanged: ${problems[0]}${others}. Agents reject the file until it is corrected.`];
}

/** Collects remarks about rows and merges equal ones into one sentence with a count. */
export class Remarks {
  /** @type {Map<string, number[]>} */
  #lines = new Map();

  /** @param {string} what remark with “#” as the placeholder for the lines @param {Row} row */
  add(what, row) {
    this.#lines.set(what, [...(this.#lines.get(what) ?? []), row.number]);
  }

  /** @returns {string[]} */
  get notes() {
    return [...this.#lines].map(([what, lines]) => what.replace('#', placesText([...new Set(lines)])));
  }
}

/** @param {number[]} lines @returns {string} text such as: line 3, and 2 more */
function placesText([first, ...others]) {
  return `line ${first}${others.length > 0 ? `, and ${others.length} more` : ''}`;
}

/**
 * Maps column names to joints.
 *
 * @param {Row} row header row
 * @param {readonly string[]} written names of all angle columns; empty for an ignored one
 * @param {(name: string) => Column | undefined} columnOf
 * @returns {Columns}
 * @throws {Error} if no column is a joint, a column has no name, or two columns are the same joint; the message is meant for the user
 */
export function columnsOf(row, written, columnOf) {
  const names = withoutEmptyEnd(written);
  const columns = names.map(columnOf);
  const nameless = names.indexOf('');
  if (nameless >= 0) {
    throw new Error(`line ${row.number} has no name for its angle column ${nameless + 1}. Add one.`);
  }
  if (!columns.some(Boolean)) {
    const found = names.length > 0 ? `: found “${names.slice(0, 3).join('”, “')}”` : '';
    throw new Error(`line ${row.number} names no joint of this robot${found}.`);
  }
  const joints = columns.map((column) => column?.joint);
  const twice = joints.findIndex((joint, i) => joint !== undefined && joints.indexOf(joint) < i);
  if (twice >= 0) {
    const other = names[joints.indexOf(joints[twice])];
    const both = other === names[twice] ? `“${other}” twice` : `one joint twice, as “${other}” and “${names[twice]}”`;
    throw new Error(`line ${row.number} names ${both}. Remove one of the columns.`);
  }
  return { names, columns };
}

/** @param {Columns} columns @param {Body} body @returns {string[]} remarks about columns and joints without a counterpart */
export function columnNotes({ names, columns }, { joints }) {
  const unknown = names.filter((_, i) => !columns[i]);
  const named = new Set(columns.map((column) => column?.joint));
  const missing = joints.filter((_, i) => !named.has(i)).map(({ name }) => name);
  return [
    ...(unknown.length > 0 ? [`Skipped ${unknown.join(', ')}, which this robot does not have.`] : []),
    ...(missing.length > 0 ? [`No column for ${listText(missing)}: the angles of the start posture are used.`] : []),
  ];
}

/** @param {string[]} names */
function listText(names) {
  const limit = 3;
  const shown = names.slice(0, limit).join(', ');
  return names.length > limit ? `${shown} and ${names.length - limit} more joints` : shown;
}

/** @param {readonly string[]} cells @returns {string[]} the cells without trailing empty ones */
export function withoutEmptyEnd(cells) {
  const last = cells.findLastIndex((cell) => cell !== '');
  return cells.slice(0, last + 1);
}

/**
 * Applies the angles of a row to a posture.
 *
 * @param {Row} row
 * @param {readonly string[]} cells cells with its angles
 * @param {'degrees' | 'radians'} unit
 * @param {Columns} columns
 * @param {readonly number[]} before angles for cells that are empty
 * @param {Remarks} remarks
 * @returns {number[]}
 */
export function postureOf(row, cells, unit, { names, columns }, before, remarks) {
  const example = unit === 'degrees' ? '-12.5' : '-0.35';
  const toDegrees = unit === 'degrees' ? 1 : 180 / Math.PI;
  const values = [...cells.slice(0, names.length), ...withoutEmptyEnd(cells.slice(names.length))];
  if (values.length !== names.length) {
    throw new UnreadableRow(`found ${values.length} angles, expected ${names.length}, one for each named joint`);
  }
  const next = [...before];
  columns.forEach((column, i) => {
    if (column && values[i] === '') {
      remarks.add('Where a cell is empty (#), the joint keeps its angle.', row);
    } else if (column && values[i] !== '*') {
      next[column.joint] = fourDecimals(
        column.sign * toDegrees * numberIn(values[i], `an angle in ${unit}, such as ${example}`),
      );
    }
  });
  return next;
}

/**
 * Converts absolute times into durations between keyframes.
 *
 * @param {Remarks} remarks
 * @returns {(millis: number, row: Row) => number} function that returns the duration up to a time; must be called in chronological order
 */
export function waysBetween(remarks) {
  let before = -1;
  let reached = 0;
  return (millis, row) => {
    if (millis <= before) {
      throw new UnreadableRow(`found the time ${millis} ms, expected a time later than the previous one, ${before} ms`);
    }
    const way = Math.round(millis - reached);
    if (before >= 0 && way < MIN_WAY) {
      remarks.add('Times shorter than one cycle of 20 ms are extended to 20 ms (#).', row);
    }
    before = millis;
    reached += Math.max(MIN_WAY, way);
    return Math.max(MIN_WAY, way);
  };
}

const NUMBER = /^[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?$/;

/** @param {string} text @param {string} expected @returns {number} */
export function numberIn(text, expected) {
  const value = Number(text);
  if (!NUMBER.test(text) || !Number.isFinite(value)) {
    throw new UnreadableRow(`found “${text}”, expected ${expected}`);
  }
  return value;
}

/** @param {string} text @param {string} expected @returns {number} */
export function positiveIn(text, expected) {
  const value = numberIn(text, expected);
  if (value <= 0) {
    throw new UnreadableRow(`found “${text}”, expected ${expected} above 0`);
  }
  return value;
}

/** Returns the keyframes for export: each transition takes at least one cycle, as during playback. @param {readonly Keyframe[]} frames */
export function playedFrames(frames) {
  return frames.map((frame) => ({ ...frame, millis: Math.max(MIN_WAY, frame.millis) }));
}
