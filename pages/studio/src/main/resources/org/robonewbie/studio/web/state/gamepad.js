/** Maps a gamepad to robot commands: the left stick walks, the right stick and the triggers turn, and the buttons kick. Pure. */

const DEAD = 0.18;
const STEPS = 5;

/** Buttons of the standard gamepad layout. @type {Record<number, string>} */
const MOTIONS = { 0: 'kick-right', 2: 'kick-left', 3: 'wave', 1: 'stand' };

/**
 * @typedef {object} Pad gamepad state as reported by the browser
 * @property {readonly number[]} axes
 * @property {ReadonlyArray<{pressed: boolean}>} buttons
 */

/**
 * @param {Pad} pad
 * @returns {import('./puppet.js').Walk} quantised, so that small thumb movements do not cause new commands
 */
export function walkOfPad({ axes }) {
  const part = (/** @type {number | undefined} */ value = 0) =>
    Math.abs(value) < DEAD ? 0 : -Math.round(STEPS * value) / STEPS || 0;
  return { forward: part(axes[1]), left: part(axes[0]), turn: part(axes[2]) };
}

/**
 * @param {Pad} pad
 * @param {ReadonlySet<number>} before buttons that were pressed at the previous call
 * @returns {{down: Set<number>, motion: string | undefined}} buttons that are pressed, and the motion just requested
 */
export function buttonsOfPad({ buttons }, before) {
  const down = new Set([...buttons.keys()].filter((i) => buttons[i].pressed));
  const fresh = [...down].find((i) => !before.has(i) && MOTIONS[i] !== undefined);
  return { down, motion: fresh === undefined ? undefined : MOTIONS[fresh] };
}

/** Help text. */
export const PAD_TEXT = 'Gamepad: left stick walks, right stick turns, A and X kick, Y waves, B stands.';
