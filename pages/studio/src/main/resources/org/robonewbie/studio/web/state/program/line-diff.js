/**
 * Line-by-line comparison of two versions of a file. Pure.
 *
 * @typedef {{sign: ' ' | '−' | '+', text: string}} DiffLine a line that is in both versions, only in the first, or only in the second
 */
/** Maximum number of cells in the table of the longest common subsequence. */
const MAX_CELLS = 1_000_000;
const CONTEXT_LINES = 3;

/** @param {string} before @param {string} after @returns {DiffLine[]} */
export function lineDiff(before, after) {
  const first = before.split('\n');
  const second = after.split('\n');
  const head = commonLines(first, second);
  const tail = commonLines(first.slice(head).reverse(), second.slice(head).reverse());
  return [
    ...signed(' ', first.slice(0, head)),
    ...middle(first.slice(head, first.length - tail), second.slice(head, second.length - tail)),
    ...signed(' ', first.slice(first.length - tail)),
  ];
}

/** Returns the number of common lines at the beginning. @param {readonly string[]} before @param {readonly string[]} after */
export function commonLines(before, after) {
  const first = after.findIndex((line, i) => line !== before[i]);
  return first < 0 ? after.length : first;
}

/** @param {DiffLine['sign']} sign @param {readonly string[]} lines @returns {DiffLine[]} */
const signed = (sign, lines) => lines.map((text) => ({ sign, text }));

/**
 * Compares lines by their longest common subsequence; if there are too many lines, all of them count as different.
 *
 * @param {string[]} before
 * @param {string[]} after
 */
function middle(before, after) {
  if (before.length * after.length > MAX_CELLS) {
    return [...signed('−', before), ...signed('+', after)];
  }
  const common = commonLengths(before, after);
  /** @type {DiffLine[]} */
  const lines = [];
  let [i, j] = [0, 0];
  while (i < before.length || j < after.length) {
    if (i < before.length && before[i] === after[j]) {
      lines.push({ sign: ' ', text: before[i] });
      i += 1;
      j += 1;
    } else if (j === after.length || (i < before.length && common[i + 1][j] >= common[i][j + 1])) {
      lines.push({ sign: '−', text: before[i] });
      i += 1;
    } else {
      lines.push({ sign: '+', text: after[j] });
      j += 1;
    }
  }
  return lines;
}

/**
 * Returns the length of the longest common subsequence of the lines from i on and those from j on.
 *
 * @param {string[]} before
 * @param {string[]} after
 */
function commonLengths(before, after) {
  const lengths = Array.from({ length: before.length + 1 }, () => new Uint32Array(after.length + 1));
  for (let i = before.length - 1; i >= 0; i -= 1) {
    for (let j = after.length - 1; j >= 0; j -= 1) {
      lengths[i][j] =
        before[i] === after[j] ? lengths[i + 1][j + 1] + 1 : Math.max(lengths[i + 1][j], lengths[i][j + 1]);
    }
  }
  return lengths;
}

/** @param {readonly DiffLine[]} lines @returns {number} changed lines; a line that replaces another one counts once */
export function changedLines(lines) {
  let total = 0;
  let [removed, added] = [0, 0];
  for (const { sign } of [...lines, { sign: ' ' }]) {
    removed += sign === '−' ? 1 : 0;
    added += sign === '+' ? 1 : 0;
    if (sign === ' ') {
      total += Math.max(removed, added);
      [removed, added] = [0, 0];
    }
  }
  return total;
}

/** @param {readonly DiffLine[]} lines @returns {Array<DiffLine | undefined>} lines near changes; undefined for each gap */
export function nearChanges(lines) {
  const isNear = lines.map((_, i) =>
    lines.slice(Math.max(0, i - CONTEXT_LINES), i + CONTEXT_LINES + 1).some(({ sign }) => sign !== ' '),
  );
  return lines.flatMap((line, i) => (isNear[i] ? [line] : i === 0 || isNear[i - 1] ? [undefined] : []));
}
