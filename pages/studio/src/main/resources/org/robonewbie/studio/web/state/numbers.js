/** Numbers as people read them. */

/**
 * @param {number} value
 * @param {number} digits behind the point
 * @returns {string} never “-0”
 */
export function fixed(value, digits) {
  const text = value.toFixed(digits);
  return /^-0(\.0*)?$/.test(text) ? text.slice(1) : text;
}

/**
 * @param {string} text as people type it, also with a comma
 * @returns {number | undefined}
 */
export function numberOf(text) {
  const number = Number(text.trim().replace(',', '.'));
  return text.trim() !== '' && Number.isFinite(number) ? number : undefined;
}

/**
 * @param {number} least
 * @returns {number} the next one of … 1, 2, 5, 10, 20, 50 … that is not smaller: the distance between two lines of a scale
 */
export function roundStep(least) {
  const decade = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5].map((each) => each * decade).find((each) => each >= least) ?? 10 * decade;
}
