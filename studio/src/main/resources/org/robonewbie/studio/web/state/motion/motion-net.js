/**
 * The nets of the original motion editor (.mef): a line with the word nao, the names of the joints, keyframes with number and place
 * on the screen, and transitions between them. The motion is the way along the first transitions from keyframe 0, whose own posture is
 * not part of it. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./foreign.js').Imported} Imported
 * @typedef {import('./foreign.js').Row} Row
 *
 * @typedef {object} Net
 * @property {number[]} columns joint of each angle, in the order of the file
 * @property {Map<number, number[]>} postures by number
 * @property {Array<{from: number, to: number, millis: number, row: Row}>} transitions
 * @property {Map<number, string>} problems by line
 */
import { documentOfRows, fourDecimals, numberIn, problemNotes, rowsOf, UnreadableRow } from './foreign.js';
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
  const ways = frames.map(({ millis }, i) => ['transition', i, i + 1, millis, '*'].join(';'));
  const names = ORIGINAL_JOINTS.map((name) => `${name};`).join('');
  return ['nao', '', names, '', ...nodes, '', ...ways, ''].join('\r\n');
}

/**
 * @param {string} text
 * @param {readonly number[]} start angles of joints of which the file says nothing
 * @returns {Imported}
 * @throws {Error} if it is no such net; the message is meant for people
 */
export function readNet(text, start) {
  const [head, ...rows] = rowsOf(text);
  if (head?.text !== 'nao') {
    throw new Error('This is no net of the original motion editor: its first line is not “nao”.');
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
  return { document, notes: [...branchNotes(net, steps.length), ...end, ...problemNotes(document)] };
}

/** @param {Row} row */
function isTransition({ text }) {
  return text.startsWith('transition');
}

/** @param {Net} net @param {number} taken */
function branchNotes({ transitions }, taken) {
  const others = transitions.length - taken;
  return others > 0 ? [`A motion has one way: ${others} other transitions are kept as comments.`] : [];
}

/** @param {readonly Row[]} rows @param {readonly number[]} start @returns {Net} */
function netOf(rows, start) {
  /** @type {Net} */
  const net = { columns: [], postures: new Map(), transitions: [], problems: new Map() };
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
  return net;
}

/** @param {Net} net @param {Row} row @param {readonly number[]} start */
function addRow(net, row, start) {
  const cells = row.text.split(';').map((cell) => cell.trim());
  if (cells[0] === 'keyframe') {
    const [id, , , ...angles] = cells.slice(1).map((cell) => numberIn(cell, 'a number'));
    if (angles.length !== net.columns.length) {
      throw new UnreadableRow(
        `found ${angles.length} angles, expected ${net.columns.length}, one for each named joint`,
      );
    }
    const degrees = [...start];
    angles.forEach((angle, i) => {
      degrees[net.columns[i]] = fourDecimals(angle);
    });
    net.postures.set(id, degrees);
  } else if (cells[0] === 'transition') {
    const [from, to, millis] = cells.slice(1, 4).map((cell) => numberIn(cell, 'a number'));
    net.transitions.push({ from, to, millis: Math.max(20, Math.round(millis)), row });
  } else if (!row.text.startsWith('#')) {
    net.columns.push(...cells.filter((cell) => cell !== '').map(jointOf));
  }
}

/** @param {string} name */
function jointOf(name) {
  const joint = ORIGINAL_JOINTS.indexOf(name);
  if (joint < 0) {
    throw new UnreadableRow(`found “${name}”, expected keyframe, transition or the name of a joint`);
  }
  return joint;
}

/** The way along the first transitions, until it ends or comes to a keyframe again. @param {Net} net */
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
      return { steps, end: [`The net goes on at keyframe ${step.to} again; the motion ends there.`] };
    }
    steps.push(step);
    visited.add(step.to);
    at = step.to;
  }
}
