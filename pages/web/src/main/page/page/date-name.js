/** Default name of a recording. */

/** @param {Date} time @returns {string} text such as `2026-11-24 09-30-05` */
export function dateName(time) {
  const two = (/** @type {number} */ number) => String(number).padStart(2, '0');
  const day = [time.getFullYear(), two(time.getMonth() + 1), two(time.getDate())].join('-');
  return `${day} ${[time.getHours(), time.getMinutes(), time.getSeconds()].map(two).join('-')}`;
}
