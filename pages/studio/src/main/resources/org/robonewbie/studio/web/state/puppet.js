/** Keyboard control of a robot. Pure. */

/**
 * @typedef {object} Walk walking command; all values from -1 to 1
 * @property {number} forward
 * @property {number} left
 * @property {number} turn
 *
 * @typedef {object} PuppetKey
 * @property {string} key name of the key in the browser
 * @property {string} shown label of the key
 * @property {string} text
 * @property {Partial<Walk>} [walk] while the key is held
 * @property {string} [motion] performed once
 * @property {[number, number]} [look] degrees by which the head turns left and up
 */

/** @type {PuppetKey[]} */
export const PUPPET_KEYS = [
  { key: 'w', shown: 'W', text: 'walk forward', walk: { forward: 1 } },
  { key: 's', shown: 'S', text: 'walk backward', walk: { forward: -1 } },
  { key: 'a', shown: 'A', text: 'turn left', walk: { turn: 1 } },
  { key: 'd', shown: 'D', text: 'turn right', walk: { turn: -1 } },
  { key: 'q', shown: 'Q', text: 'step to the left', walk: { left: 1 } },
  { key: 'e', shown: 'E', text: 'step to the right', walk: { left: -1 } },
  { key: 'f', shown: 'F', text: 'kick with the left foot', motion: 'kick-left' },
  { key: 'g', shown: 'G', text: 'kick with the right foot', motion: 'kick-right' },
  { key: 'v', shown: 'V', text: 'wave', motion: 'wave' },
  { key: 'h', shown: 'H', text: 'head to the left', look: [15, 0] },
  { key: 'j', shown: 'J', text: 'head to the right', look: [-15, 0] },
  { key: 'u', shown: 'U', text: 'head up', look: [0, 10] },
  { key: 'm', shown: 'M', text: 'head down', look: [0, -10] },
];

/** @param {string} key @returns {PuppetKey | undefined} */
export function puppetKey(key) {
  return PUPPET_KEYS.find((each) => each.key === key.toLowerCase());
}

/**
 * @param {Iterable<string>} held pressed keys
 * @returns {Walk}
 */
export function walkOf(held) {
  const walk = { forward: 0, left: 0, turn: 0 };
  for (const key of held) {
    const part = puppetKey(key)?.walk;
    walk.forward += part?.forward ?? 0;
    walk.left += part?.left ?? 0;
    walk.turn += part?.turn ?? 0;
  }
  return walk;
}

/**
 * @param {[number, number]} gaze direction of the head, degrees to the left and up
 * @param {[number, number]} by
 * @returns {[number, number]}
 */
export function turned(gaze, by) {
  const cut = (/** @type {number} */ value, /** @type {number} */ limit) => Math.max(-limit, Math.min(limit, value));
  return [cut(gaze[0] + by[0], 115), cut(gaze[1] + by[1], 43)];
}
