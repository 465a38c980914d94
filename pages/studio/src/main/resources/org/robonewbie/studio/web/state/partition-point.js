/**
 * Binary search.
 *
 * @param {number} length of a list
 * @param {(index: number) => boolean} isBefore true for the first entries and false for all others
 * @returns {number} the number of the first entries
 */
export function partitionPoint(length, isBefore) {
  let [low, high] = [0, length];
  while (low < high) {
    const middle = (low + high) >> 1;
    [low, high] = isBefore(middle) ? [middle + 1, high] : [low, middle];
  }
  return low;
}
