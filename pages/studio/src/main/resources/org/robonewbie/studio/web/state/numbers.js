/** Formatting and parsing of numbers. */

/**
 * @param {number} value
 * @param {number} digits digits after the decimal point
 * @returns {string} never “-0”
 */
export function fixed(value, digits) {
  const text = value.toFixed(digits);
  return /^-0(\.0*)?$/.test(text) ? text.slice(1) : text;
}

/**
 * @param {string} text user input, with a decimal point or comma
 * @returns {number | undefined}
 */
export function numberOf(text) {
  const number = Number(text.trim().replace(',', '.'));
  return text.trim() !== '' && Number.isFinite(number) ? number : undefined;
}

/**
 * @param {number} min
 * @returns {number} the tick spacing: the smallest of … 1, 2, 5, 10, 20, 50 … that is not below `min`
 */
export function roundStep(min) {
  const decade = 10 ** Math.floor(Math.log10(min));
  return [1, 2, 5].map((each) => each * decade).find((each) => each >= min) ?? 10 * decade;
}

/** @param {number} degrees @returns {number} the angle rounded to four decimals, which exceeds the precision of any motor; never -0 */
export function fourDecimals(degrees) {
  return Math.round(degrees * 1e4) / 1e4 + 0;
}
