/**
 * Sliders for the numbers that a program declares with `number("gain", 0.5, 0, 1)`. Pure.
 *
 * @typedef {object} DeclaredNumber
 * @property {string} name
 * @property {number} usual its value in the program's text
 * @property {number} least
 * @property {number} most
 * @property {number} value its present value
 */

const STEPS = 200;
const PATIENCE_MILLISECONDS = 500;
const NAME = /[.*+?^${}()|[\]\\]/g;

/** @param {DeclaredNumber} number @returns {number} how far one press of a key moves its slider: 1, 2 or 5 of some decimal */
export function stepOf({ least, most }) {
  const exact = (most - least) / STEPS;
  const power = 10 ** Math.floor(Math.log10(exact));
  const factor = [1, 2, 5, 10].find((each) => each * power >= exact * (1 - 1e-9)) ?? 10;
  return Number((factor * power).toPrecision(1));
}

/** @param {number} value @returns {string} without the noise behind the last digit that matters */
export function numberText(value) {
  return String(Number(value.toPrecision(6)));
}

/**
 * Writes another usual value into a program's text.
 *
 * @param {string} text of the program
 * @param {string} name of the number
 * @param {number} value
 * @returns {string | undefined} the text; undefined if the value does not stand there as a plain number
 */
export function withUsual(text, name, value) {
  const declared = new RegExp(
    String.raw`(\bnumber\(\s*"${name.replaceAll(NAME, String.raw`\$&`)}"\s*,\s*)-?[\d.]+(?:[eE][+-]?\d+)?[dDfF]?(?=\s*,)`,
  );
  return declared.test(text) ? text.replace(declared, `$1${numberText(value)}`) : undefined;
}

/** Which values somebody has chosen; a program that begins once more is told them again. */
export class ChosenNumbers {
  /** @type {Map<string, {usual: number, value: number, toldAt: number}>} */
  #chosen = new Map();

  /** @param {DeclaredNumber} number @param {number} value @param {number} now in milliseconds */
  choose({ name, usual }, value, now) {
    this.#chosen.set(name, { usual, value, toldAt: now });
  }

  /** Another program is shown. */
  forget() {
    this.#chosen.clear();
  }

  /** @param {DeclaredNumber} number that the program has @returns {number} the value that its slider shows */
  shown({ name, usual, value }) {
    const chosen = this.#chosen.get(name);
    if (chosen && chosen.usual !== usual) {
      this.#chosen.delete(name);
      return value;
    }
    return chosen ? chosen.value : value;
  }

  /**
   * @param {DeclaredNumber} number that the program has
   * @param {number} now in milliseconds
   * @returns {number | undefined} the chosen value, if the program should know it by now and does not
   */
  wish(number, now) {
    const shown = this.shown(number);
    const chosen = this.#chosen.get(number.name);
    if (!chosen || shown === number.value || now - chosen.toldAt < PATIENCE_MILLISECONDS) {
      return undefined;
    }
    chosen.toldAt = now;
    return shown;
  }
}
