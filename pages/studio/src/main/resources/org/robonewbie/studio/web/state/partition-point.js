/**
 * Finds by binary search how many entries at the start of a list satisfy a condition.
 *
 * @param {number} length length of the list
 * @param {(index: number) => boolean} isBefore true for the entries at the start and false for all others
 * @returns {number} the number of entries that satisfy the condition, which is the index of the first one that does not
 */
export function partitionPoint(length, isBefore) {
  let [low, high] = [0, length];
  while (low < high) {
    const middle = (low + high) >> 1;
    [low, high] = isBefore(middle) ? [middle + 1, high] : [low, middle];
  }
  return low;
}
