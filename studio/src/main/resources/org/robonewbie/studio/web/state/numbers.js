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
