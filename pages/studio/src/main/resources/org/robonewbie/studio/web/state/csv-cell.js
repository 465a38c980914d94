/** Cells of CSV tables (RFC 4180). Pure. */

const NUMBER = /^\s*[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\s*$/;

/** Start of a formula, even after blanks or in the full-width forms that some spreadsheets accept. */
const FORMULA = /^(?:[\t\r\n]|[\s\p{Cc}\p{Cf}\p{Z}]*[=+\-@＝＋－＠])/u;

/**
 * @param {string} text
 * @returns {string} the cell; text that a spreadsheet would treat as a formula is prefixed with an apostrophe
 */
export function csvCell(text) {
  const safe = FORMULA.test(text) && !NUMBER.test(text) ? `'${text}` : text;
  return /[,"\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}
