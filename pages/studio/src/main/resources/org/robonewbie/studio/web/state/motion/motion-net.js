/**
 * Keyframe nets of the original motion editor (.mef): a line with the word nao, the joint names, keyframes with their numbers and screen
 * positions, and transitions between them. The motion begins with the transition from keyframe 0 and follows the first transition of each
 * keyframe; it does not include the posture of keyframe 0. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./foreign.js').Imported} Imported
 * @typedef {import('./foreign.js').Row} Row
 * @typedef {import('./foreign.js').Columns} Columns
 *
 * @typedef {object} Net
 * @property {Columns | undefined} columns joint of each angle, in the order of the file; undefined before the header
 * @property {Remarks} remarks
 * @property {Map<number, number[]>} postures postures by number
 * @property {Array<{from: number, to: number, millis: number, row: Row}>} transitions
 * @property {Map<number, string>} problems problems by line
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
  UnreadableRow,
  withoutEmptyEnd,
} from './foreign.js';
import { numberText } from './motion-text.js';
import { ORIGINAL_JOINTS } from './webots.js';

const COLUMNS = 6;
const SPACING = 100;

/**
 * @param {readonly Keyframe[]} frames
 * @param {readonly number[]} start posture before the motion, keyframe 0 of the net
 * @returns {string}
 */
export function writeNet(frames, start) {
  const postures = [start, ...frames.map(({ degrees }) => degrees)];
  const places = postures.map((_, i) => [SPACING * (1 + (i % COLUMNS)), SPACING * (1 + Math.floor(i / COLUMNS))]);
  const nodes = postures.map((degrees, i) => ['keyframe', i, ...places[i], ...degrees.map(numberText)].join(';'));
  const ways = playedFrames(frames).map(({ millis }, i) => ['transition', i, i + 1, millis, '*'].join(';'));
  const names = ORIGINAL_JOINTS.map((name) => `${name};`).join('');
  return ['nao', '', names, '', ...nodes, '', ...ways, ''].join('\r\n');
}

/**
 * @param {string} text
 * @param {Body} body
 * @param {readonly number[]} start angles of joints that the file lacks
 * @returns {Imported}
 * @throws {Error} if it is not a keyframe net; the message is meant for the user
 */
export function readNet(text, body, start) {
  const [head, ...rows] = rowsOf(text);
  if (head?.text !== 'nao') {
    throw new Error('This is not a net of the original motion editor: its first line is not “nao”.');
  }
  const net = netOf(rows, start);
  const { steps, end } = chainOf(net);
  const taken = new Map(steps.map((step) => [step.row, step]));
  const shown = rows.filter((row) => net.problems.has(row.number) || isTransition(row));
  const order = [...steps.map(({ row }) => row), ...shown.filter((row) => !taken.has(row))];
  const document = documentOfRows(order, (row) => {
    const step = taken.get(row);
    const problem = net.problems.get(row.number);
    if (problem) {
      throw new UnreadableRow(problem);
    }
    return step
      ? { millis: step.millis, degrees: /** @type {number[]} */ (net.postures.get(step.to)) }
      : `another branch: ${row.text}`;
  });
  const notes = [...branchNotes(net, steps.length), ...end, ...net.remarks.notes, ...problemNotes(document)];
  return { document, notes: [...(net.columns ? columnNotes(net.columns, body) : []), ...notes] };
}

/** @param {Row} row */
function isTransition({ text }) {
  return text.startsWith('transition');
}

/** @param {Net} net @param {number} taken */
function branchNotes({ transitions }, taken) {
  const others = transitions.length - taken;
  return others > 0 ? [`A motion has a single path: ${others} other transitions are kept as comments.`] : [];
}

/** @param {readonly Row[]} rows @param {readonly number[]} start @returns {Net} */
function netOf(rows, start) {
  /** @type {Net} */
  const net = {
    columns: undefined,
    remarks: new Remarks(),
    postures: new Map(),
    transitions: [],
    problems: new Map(),
  };
  for (const row of rows) {
    try {
      addRow(net, row, start);
    } catch (error) {
      if (!(error instanceof UnreadableRow)) {
        throw error;
      }
      net.problems.set(row.number, error.message);
    }
  }
  for (const { from, to, row } of net.transitions) {
    const missing = [from, to].find((id) => !net.postures.has(id));
    if (missing !== undefined) {
      net.problems.set(row.number, `the file has no readable keyframe ${missing}`);
    }
  }
  return net;
}

/** @param {Net} net @param {Row} row @param {readonly number[]} start */
function addRow(net, row, start) {
  const cells = row.text.split(';').map((cell) => cell.trim());
  if (cells[0] === 'keyframe') {
    addKeyframe(net, row, cells, start);
  } else if (cells[0] === 'transition') {
    const [from, to] = cells.slice(1, 3).map((cell) => numberIn(cell, 'a keyframe number'));
    const millis = positiveIn(cells[3] ?? '', 'a time in milliseconds');
    net.transitions.push({ from, to, millis: Math.max(20, Math.round(millis)), row });
  } else if (!row.text.startsWith('#')) {
    withoutEmptyEnd(cells).forEach(refuseOther);
    if (net.columns) {
      throw new UnreadableRow(`found “${cells[0]}”, but the joints have already been named`);
    }
    net.columns = columnsOf(row, cells, (name) => ({ joint: ORIGINAL_JOINTS.indexOf(name), sign: 1 }));
  }
}

/** @param {Net} net @param {Row} row @param {string[]} cells @param {readonly number[]} start */
function addKeyframe(net, row, cells, start) {
  const [id] = cells.slice(1, 4).map((cell) => numberIn(cell, 'a number'));
  if (!net.columns) {
    throw new UnreadableRow('found a keyframe, expected a line with the joint names before it');
  }
  if (net.postures.has(id)) {
    throw new UnreadableRow(`found keyframe ${id}, which is already defined`);
  }
  net.postures.set(id, postureOf(row, cells.slice(4), 'degrees', net.columns, start, net.remarks));
}

/** @param {string} name */
function refuseOther(name) {
  if (!ORIGINAL_JOINTS.includes(name)) {
    throw new UnreadableRow(`found “${name}”, expected “keyframe”, “transition” or a joint name`);
  }
}

/** Follows the first transition of each keyframe, from keyframe 0 to the end or until a keyframe is revisited. @param {Net} net */
function chainOf({ postures, transitions }) {
  /** @type {Net['transitions']} */
  const steps = [];
  const visited = new Set([0]);
  for (let at = 0; ;) {
    const step = transitions.find(({ from, to }) => from === at && postures.has(to));
    if (!step) {
      return { steps, end: [] };
    }
    if (visited.has(step.to)) {
      return { steps, end: [`The net returns to keyframe ${step.to}; the motion ends there.`] };
    }
    steps.push(step);
    visited.add(step.to);
    at = step.to;
  }
}
