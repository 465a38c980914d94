/**
 * Webots .motion files, also used with Choregraphe: a header with the joint names on the same line or the next, then a line with time, pose
 * name and angles in radians for each keyframe. Some league teams write V1.1, where a row consists of the word “play”, the angles in
 * radians and the duration in seconds, separated by %. There are two sign conventions: Webots uses the signs and names of NAO's
 * documentation, where bent knees and lowered arms are positive; the original motion editor uses the simulator's signs. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./foreign.js').Imported} Imported
 * @typedef {'nao' | 'original'} Reading
 * @typedef {import('./foreign.js').Row} Row
 * @typedef {import('./foreign.js').Column} Column
 *
 * @typedef {object} Table parts of a Webots motion
 * @property {Row} head header with the names
 * @property {string[]} names
 * @property {Row[]} rows
 * @property {string} separator cell separator
 */
import {
  columnNotes,
  columnsOf,
  documentOfRows,
  playedFrames,
  positiveIn,
  postureOf,
  problemNotes,
  Remarks,
  rowsOf,
  UnreadableRow,
  waysBetween,
} from './foreign.js';

const HEAD = '#WEBOTS_MOTION,V1.0';

/** Joint names of the original motion editor, in the order of the motion files. */
export const ORIGINAL_JOINTS = [
  'HeadYaw',
  'HeadPitch',
  'LShoulderPitch',
  'LShoulderRoll',
  'LElbowRoll',
  'LElbowYaw',
  'LHipYawPitch',
  'LHipRoll',
  'LHipPitch',
  'LKneePitch',
  'LAnklePitch',
  'LAnkleRoll',
  'RHipYawPitch',
  'RHipRoll',
  'RHipPitch',
  'RKneePitch',
  'RAnklePitch',
  'RAnkleRoll',
  'RShoulderPitch',
  'RShoulderRoll',
  'RElbowRoll',
  'RElbowYaw',
];

const RANGE_SLACK = 2;
/** First word of the rows of version 1.1. */
const PLAY = 'play';

/** NAO's ElbowYaw is the simulator's arm roll, and ElbowRoll bends the elbow. @type {string[]} */
const NAO_JOINTS = ORIGINAL_JOINTS.map((name) =>
  name.replace(/Elbow(Roll|Yaw)/, (_, turn) => `Elbow${turn === 'Roll' ? 'Yaw' : 'Roll'}`),
);

/** @param {string} name @returns {number} -1 for pitch joints, whose axes point to the left on NAO and to the right in the simulator */
function signOf(name) {
  return /(Head|Shoulder|Hip|Knee|Ankle)Pitch$/.test(name) ? -1 : 1;
}

/** @param {Reading} reading @returns {string[]} */
function namesOf(reading) {
  return reading === 'nao' ? NAO_JOINTS : ORIGINAL_JOINTS;
}

/** @param {Reading} reading @param {string} name name such as “LElbowRoll” or “LElbowRoll{S}” @returns {Column | undefined} */
export function columnOf(reading, name) {
  const plain = name.trim().replace(/\{.*\}$/, '');
  const joint = namesOf(reading).indexOf(plain);
  return joint < 0 ? undefined : { joint, sign: reading === 'nao' ? signOf(plain) : 1 };
}

/**
 * @param {readonly Keyframe[]} frames
 * @param {Reading} reading
 * @returns {string}
 */
export function writeWebots(frames, reading) {
  const names = namesOf(reading);
  let time = 0;
  const lines = playedFrames(frames).map(({ millis, degrees }, i) => {
    time += millis;
    const angles = names.map((name, joint) => radiansText((reading === 'nao' ? signOf(name) : 1) * degrees[joint]));
    return [timeText(time), `Pose${i + 1}`, ...angles].join(',');
  });
  return [[HEAD, ...names].join(','), ...lines, ''].join('\n');
}

/**
 * @param {string} text
 * @param {Body} body
 * @param {readonly number[]} start angles of joints that the file lacks
 * @returns {Imported}
 * @throws {Error} if it is not a Webots motion; the message is meant for the user
 */
export function readWebots(text, body, start) {
  const table = tableOf(rowsOf(text));
  const [nao, original] = /** @type {Reading[]} */ (['nao', 'original']).map((reading) => ({
    reading,
    ...readAs(reading, table, start),
  }));
  const found = outOfRange(nao.document, body) <= outOfRange(original.document, body) ? nao : original;
  const signs =
    found.reading === 'nao'
      ? 'Angles were read with NAO’s sign conventions, as Webots writes them.'
      : 'Angles were read with the sign conventions of the original motion editor.';
  const { document, columns, remarks } = found;
  return { document, notes: [signs, ...columnNotes(columns, body), ...remarks.notes, ...problemNotes(document)] };
}

/** @param {Row[]} all @returns {Table} */
function tableOf([head, ...rest]) {
  const [magic, version = '', ...written] = (head?.text ?? '').split(',').map((cell) => cell.trim());
  if (!magic.startsWith('#WEBOTS_MOTION')) {
    throw new Error('This is not a Webots motion: its first line does not begin with #WEBOTS_MOTION.');
  }
  if (!/^V1\.[01]$/.test(version)) {
    throw new Error(`This Webots motion has version “${version}”; only V1.0 and V1.1 can be read.`);
  }
  if (written.every((name) => name === '')) {
    return tableBelow(rest);
  }
  return { head, names: written, rows: rest, separator: separatorOf(rest[0]) };
}

/** @param {Row | undefined} row */
function separatorOf(row) {
  return row?.text.includes('%') ? '%' : ',';
}

/** Reads a file that has the names on the line below the header. @param {Row[]} all @returns {Table} */
function tableBelow([names, ...rows]) {
  const separator = separatorOf(names);
  const cells = (names?.text ?? '').split(separator).map((cell) => cell.trim());
  if (cells[0] === '' || cells[0] === PLAY || /^[\d:.]+$/.test(cells[0])) {
    throw new Error('This Webots motion names no joints, neither in its first line nor in the one below.');
  }
  return { head: names, names: cells, rows, separator };
}

/** @param {Reading} reading @param {Table} table @param {readonly number[]} start */
function readAs(reading, { head, names, rows, separator }, start) {
  const columns = columnsOf(head, names, (name) => columnOf(reading, name));
  const remarks = new Remarks();
  const wayTo = waysBetween(remarks);
  let degrees = start;
  const document = documentOfRows(rows, (row) => {
    const all = row.text.split(separator).map((cell) => cell.trim());
    const isPlay = all[0] === PLAY;
    const moment = isPlay ? 0 : momentOf(all[0]);
    const cells = isPlay ? all.slice(1, -1) : all.slice(2);
    const next = postureOf(row, cells, 'radians', columns, degrees, remarks);
    const millis = isPlay ? 1000 * positiveIn(all[all.length - 1], 'the duration in seconds') : wayTo(moment, row);
    if (isPlay) {
      remarks.add('The number at the end of each line was read as its duration in seconds (from # on).', head);
    }
    degrees = next;
    return { millis: Math.max(1, Math.round(millis)), degrees };
  });
  return { document, columns, remarks };
}

/**
 * Counts the angles out of range: with the wrong sign convention, bent knees exceed their range.
 *
 * @param {import('./motion-text.js').MotionDocument} document
 * @param {Body} body
 */
function outOfRange({ lines }, { joints }) {
  return lines.reduce((sum, { keyframe }) => {
    const beyond = keyframe?.degrees.filter((angle, i) => {
      const { minDegrees, maxDegrees } = joints[i];
      return angle < minDegrees - RANGE_SLACK || angle > maxDegrees + RANGE_SLACK;
    });
    return sum + (beyond?.length ?? 0);
  }, 0);
}

/** @param {string} time time as MM:SS:mmm */
function momentOf(time) {
  const parts = /^(\d+):(\d+):(\d+)$/.exec(time);
  if (!parts) {
    throw new UnreadableRow(`found “${time}”, expected a time such as 00:01:500`);
  }
  return 60_000 * Number(parts[1]) + 1000 * Number(parts[2]) + Number(parts[3]);
}

/** @param {number} millis */
function timeText(millis) {
  const two = (/** @type {number} */ value) => String(value).padStart(2, '0');
  return `${two(Math.floor(millis / 60_000))}:${two(Math.floor(millis / 1000) % 60)}:${String(millis % 1000).padStart(3, '0')}`;
}

/** @param {number} degrees */
function radiansText(degrees) {
  return String(Number(((degrees * Math.PI) / 180).toFixed(7)) + 0);
}
