/** Cells of tables as text with commas (RFC 4180). Pure. */

const NUMBER = /^\s*[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\s*$/;

/** Also behind blanks, and as the wide forms that some spreadsheets read alike. */
const FORMULA = /^(?:[\t\r\n]|[\s\p{Cc}\p{Cf}\p{Z}]*[=+\-@＝＋－＠])/u;

/**
 * @param {string} text
 * @returns {string} the cell; a text that a spreadsheet would take for a formula gets an apostrophe before it
 */
export function csvCell(text) {
  const safe = FORMULA.test(text) && !NUMBER.test(text) ? `'${text}` : text;
  return /[,"\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}
