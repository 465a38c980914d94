/**
 * Webots' .motion files, which Choregraphe's users exchange too: a head line with the joints' names, then a line with time, pose
 * name and radians for each keyframe. Two programs write them differently: Webots with the signs and names of NAO's documentation,
 * where bent knees and lowered arms are positive; the original motion editor with the signs of the simulator. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 * @typedef {import('./foreign.js').Imported} Imported
 * @typedef {'nao' | 'original'} Reading
 *
 * @typedef {object} Column
 * @property {number} joint index in the order of the motion files
 * @property {number} sign
 */
import { documentOfRows, fourDecimals, numberIn, problemNotes, rowsOf, UnreadableRow, waysBetween } from './foreign.js';

const HEAD = '#WEBOTS_MOTION,V1.0';

/** How the original motion editor names the 22 joints, in the order of the motion files. */
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

/** NAO turns its elbow by ElbowYaw where the simulator calls it arm roll, and bends it by ElbowRoll. @type {string[]} */
const NAO_JOINTS = ORIGINAL_JOINTS.map((name) =>
  name.replace(/Elbow(Roll|Yaw)/, (_, turn) => `Elbow${turn === 'Roll' ? 'Yaw' : 'Roll'}`),
);

/** @param {string} name @returns {number} NAO's pitch axes point to the left, those of the simulator to the right */
function signOf(name) {
  return /(Head|Shoulder|Hip|Knee|Ankle)Pitch$/.test(name) ? -1 : 1;
}

/** @param {Reading} reading @returns {string[]} */
function namesOf(reading) {
  return reading === 'nao' ? NAO_JOINTS : ORIGINAL_JOINTS;
}

/** @param {Reading} reading @param {string} name such as “LElbowRoll” or “LElbowRoll{S}” @returns {Column | undefined} */
function columnOf(reading, name) {
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
  const lines = frames.map(({ millis, degrees }, i) => {
    time += millis;
    const angles = names.map((name, joint) => radiansText((reading === 'nao' ? signOf(name) : 1) * degrees[joint]));
    return [timeText(time), `Pose${i + 1}`, ...angles].join(',');
  });
  return [[HEAD, ...names].join(','), ...lines, ''].join('\n');
}

/**
 * @param {string} text
 * @param {Body} body
 * @param {readonly number[]} start angles of joints of which the file says nothing
 * @returns {Imported}
 * @throws {Error} if it is no Webots motion; the message is meant for people
 */
export function readWebots(text, body, start) {
  const [head, ...rows] = rowsOf(text);
  if (!head?.text.startsWith('#WEBOTS_MOTION')) {
    throw new Error('This is no Webots motion: its first line does not begin with #WEBOTS_MOTION.');
  }
  const names = head.text.split(',').slice(2);
  const [nao, original] = /** @type {Reading[]} */ (['nao', 'original']).map((reading) => ({
    reading,
    document: readAs(reading, names, rows, start),
  }));
  const found = misfits(nao.document, body) <= misfits(original.document, body) ? nao : original;
  const unknown = names.filter((name) => columnOf('nao', name) === undefined);
  const signs =
    found.reading === 'nao'
      ? 'Read with NAO’s own signs, as Webots writes them.'
      : 'Read with the signs of the original motion editor.';
  const left = unknown.length > 0 ? [`Without ${unknown.join(', ')}, which this robot does not have.`] : [];
  return { document: found.document, notes: [signs, ...left, ...problemNotes(found.document)] };
}

/** @param {Reading} reading @param {string[]} names @param {import('./foreign.js').Row[]} rows @param {readonly number[]} start */
function readAs(reading, names, rows, start) {
  const columns = names.map((name) => columnOf(reading, name));
  const wayTo = waysBetween();
  let degrees = start;
  return documentOfRows(rows, (row) => {
    const [time, , ...values] = row.text.split(',').map((cell) => cell.trim());
    const moment = momentOf(time);
    const next = [...degrees];
    values.forEach((value, i) => {
      const column = columns[i];
      if (column && value !== '*' && value !== '') {
        const radians = numberIn(value, 'an angle in radians, such as -0.35');
        next[column.joint] = fourDecimals((column.sign * radians * 180) / Math.PI);
      }
    });
    degrees = next;
    return { millis: wayTo(moment), degrees };
  });
}

/** How many angles a robot could not reach: the wrong reading has bent knees beyond their range. @param {import('./motion-text.js').MotionDocument} document @param {Body} body */
function misfits({ lines }, { joints }) {
  return lines.reduce((sum, { keyframe }) => {
    const beyond = keyframe?.degrees.filter((angle, i) => {
      const { minDegrees, maxDegrees } = joints[i];
      return angle < minDegrees - RANGE_SLACK || angle > maxDegrees + RANGE_SLACK;
    });
    return sum + (beyond?.length ?? 0);
  }, 0);
}

/** @param {string} time as MM:SS:mmm */
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
