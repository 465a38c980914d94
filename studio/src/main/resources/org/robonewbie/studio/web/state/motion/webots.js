/**
 * Webots' .motion files: a head line with the joints' names, then a line with time, pose name and radians for each
 * keyframe. The signs and zeros of the angles are those of this framework, as in the original's motion editor. Pure.
 *
 * @typedef {import('./motion-text.js').Keyframe} Keyframe
 */

const HEAD = '#WEBOTS_MOTION,V1.0';

/** NAO's names for the 22 joints in the order of the motion files. */
export const WEBOTS_JOINTS = [
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

/**
 * @param {readonly Keyframe[]} frames
 * @returns {string}
 */
export function writeWebots(frames) {
  let time = 0;
  const lines = frames.map(({ millis, degrees }, i) => {
    time += millis;
    return [timeText(time), `Pose${i + 1}`, ...degrees.map((angle) => radiansText(angle))].join(',');
  });
  return [[HEAD, ...WEBOTS_JOINTS].join(','), ...lines, ''].join('\n');
}

/**
 * @param {string} text
 * @returns {Keyframe[]}
 * @throws {Error} if it is no Webots motion; the message is meant for people
 */
export function readWebots(text) {
  const [head, ...rows] = text.split(/\r\n|\r|\n/).filter((line) => line.trim() !== '');
  if (!head?.startsWith('#WEBOTS_MOTION')) {
    throw new Error('This is no Webots motion: its first line does not begin with #WEBOTS_MOTION.');
  }
  const columns = head.split(',').slice(2).map(columnOf);
  let before = 0;
  return rows.map((row, i) => {
    const [time, , ...values] = row.split(',').map((cell) => cell.trim());
    const millis = millisOf(time, i + 2);
    const degrees = new Array(WEBOTS_JOINTS.length).fill(0);
    values.forEach((value, column) => {
      if (columns[column] >= 0 && value !== '*' && value !== '') {
        degrees[columns[column]] = degreesOf(value, i + 2);
      }
    });
    const way = Math.max(20, millis - before);
    before = millis;
    return { millis: way, degrees };
  });
}

/** @param {string} name such as “LElbowRoll” or “LElbowRoll{S}” @returns {number} */
function columnOf(name) {
  return WEBOTS_JOINTS.indexOf(name.trim().replace(/\{.*\}$/, ''));
}

/** @param {string} value @param {number} line */
function degreesOf(value, line) {
  const degrees = (Number(value) * 180) / Math.PI;
  if (!Number.isFinite(degrees)) {
    throw new Error(`Line ${line} of the Webots motion has “${value}” where an angle in radians is expected.`);
  }
  return Math.round(degrees * 1e4) / 1e4 + 0;
}

/** @param {string} time as MM:SS:mmm @param {number} line */
function millisOf(time, line) {
  const parts = /^(\d+):(\d+):(\d+)$/.exec(time);
  if (!parts) {
    throw new Error(`Line ${line} of the Webots motion begins with “${time}”, expected a time such as 00:01:500.`);
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
