/**
 * Sliders for the numbers that a program declares with `number("gain", 0.5, 0, 1)`. Pure.
 *
 * @typedef {object} DeclaredNumber
 * @property {string} name
 * @property {number} defaultValue default value, from the program's text
 * @property {number} min
 * @property {number} max
 * @property {number} value current value
 */

const STEPS = 200;
const RESEND_MILLISECONDS = 500;
const NAME = /[.*+?^${}()|[\]\\]/g;

/** @param {DeclaredNumber} number @returns {number} step of its slider: 1, 2 or 5 times a power of ten */
export function stepOf({ min, max }) {
  const exact = (max - min) / STEPS;
  const power = 10 ** Math.floor(Math.log10(exact));
  const factor = [1, 2, 5, 10].find((each) => each * power >= exact * (1 - 1e-9)) ?? 10;
  return Number((factor * power).toPrecision(1));
}

/** @param {number} value @returns {string} the value without insignificant digits */
export function numberText(value) {
  return String(Number(value.toPrecision(6)));
}

/**
 * Replaces a default value in a program's text.
 *
 * @param {string} text text of the program
 * @param {string} name name of the number
 * @param {number} value
 * @returns {string | undefined} the new text; undefined if the default value is not a number literal
 */
export function withDefault(text, name, value) {
  const declared = new RegExp(
    String.raw`(\bnumber\(\s*"${name.replaceAll(NAME, String.raw`\$&`)}"\s*,\s*)-?[\d.]+(?:[eE][+-]?\d+)?[dDfF]?(?=\s*,)`,
  );
  return declared.test(text) ? text.replace(declared, `$1${numberText(value)}`) : undefined;
}

/** Values chosen by the user; they are sent again after a restart of the program. */
export class ChosenNumbers {
  /** @type {Map<string, {defaultValue: number, value: number, sentAt: number}>} */
  #chosen = new Map();

  /** @param {DeclaredNumber} number @param {number} value @param {number} now milliseconds */
  choose({ name, defaultValue }, value, now) {
    this.#chosen.set(name, { defaultValue, value, sentAt: now });
  }

  /** Called when another program is shown. */
  forget() {
    this.#chosen.clear();
  }

  /** @param {DeclaredNumber} number number declared by the program @returns {number} the value of its slider */
  shown({ name, defaultValue, value }) {
    const chosen = this.#chosen.get(name);
    if (chosen && chosen.defaultValue !== defaultValue) {
      this.#chosen.delete(name);
      return value;
    }
    return chosen ? chosen.value : value;
  }

  /**
   * @param {DeclaredNumber} number number declared by the program
   * @param {number} now milliseconds
   * @returns {number | undefined} the chosen value, if it must be sent again because the program has not adopted it
   */
  pendingValue(number, now) {
    const shown = this.shown(number);
    const chosen = this.#chosen.get(number.name);
    if (!chosen || shown === number.value || now - chosen.sentAt < RESEND_MILLISECONDS) {
      return undefined;
    }
    chosen.sentAt = now;
    return shown;
  }
}
