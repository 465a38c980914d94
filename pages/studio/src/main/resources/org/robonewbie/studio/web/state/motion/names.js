/** Display names of joints and limbs. Pure. */

/** Letters that sort the joints of MuJoCo models, such as “AAHead_yaw”. */
const SORTING = /^A+(?=[A-Z][a-z])/;

/** @param {string} name name such as LEFT_HIP_YAW_PITCH @returns {string} text such as “left hip yaw-pitch” */
export function jointName(name) {
  return name.replace(SORTING, '').toLowerCase().replace('yaw_pitch', 'yaw-pitch').replaceAll('_', ' ');
}

/** @param {string} name @returns {string} the name without the side, such as “Hip yaw-pitch” */
export function shortJointName(name) {
  const text = jointName(name).replace(/^(left|right) /, '');
  return text[0].toUpperCase() + text.slice(1);
}

/** @type {Record<string, string>} */
const LIMBS = {
  body: 'torso',
  head: 'head',
  neck: 'neck',
  upperarm: 'upper arm',
  lowerarm: 'forearm',
  thigh: 'thigh',
  shank: 'shank',
  foot: 'foot',
};

/** @param {string} name name such as “llowerarm” @returns {string} text such as “left forearm” */
export function linkName(name) {
  if (name in LIMBS) {
    return LIMBS[name];
  }
  const side = name.startsWith('l') ? 'left' : 'right';
  return `${side} ${LIMBS[name.slice(1)] ?? name.slice(1)}`;
}

/** Groups in which the joints are listed. @type {Array<{title: string, test: RegExp}>} */
const JOINT_GROUPS = [
  { title: 'Head', test: /^(NECK|A*HEAD)/i },
  { title: 'Left arm', test: /^A*LEFT_(SHOULDER|ARM|ELBOW)/i },
  { title: 'Right arm', test: /^A*RIGHT_(SHOULDER|ARM|ELBOW)/i },
  { title: 'Left leg', test: /^LEFT_(HIP|KNEE|FOOT|ANKLE)/i },
  { title: 'Right leg', test: /^RIGHT_(HIP|KNEE|FOOT|ANKLE)/i },
];

/**
 * The groups of a robot's joints, with a last one for those that fit in no other.
 *
 * @param {readonly string[]} names names of the joints
 * @param {string} others title of the last group
 * @returns {Array<{title: string, joints: number[]}>} groups that are not empty, with indices of joints
 */
export function jointGroups(names, others) {
  const isOther = (/** @type {string} */ name) => !JOINT_GROUPS.some(({ test }) => test.test(name));
  return [...JOINT_GROUPS, { title: others, test: { test: isOther } }]
    .map(({ title, test }) => ({ title, joints: names.flatMap((name, i) => (test.test(name) ? [i] : [])) }))
    .filter(({ joints }) => joints.length > 0);
}

/**
 * The joints in the order of the timeline, from head to foot.
 *
 * @param {{joints: ReadonlyArray<{name: string}>}} body
 * @returns {number[]} indices of joints
 */
export function jointRows({ joints }) {
  return jointGroups(
    joints.map(({ name }) => name),
    '',
  ).flatMap((group) => group.joints);
}
