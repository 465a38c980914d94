/** Plotted values, shown at the lines that plot them. Pure. */

const PLOT = /\bplot\(\s*"([^"\\]+)"/g;

/**
 * @param {string} text text of the program
 * @param {ReadonlyMap<string, number>} values values by name
 * @returns {Array<{line: number, text: string}>} labels for the ends of lines, in ascending order
 */
export function valuesAtLines(text, values) {
  return text.split('\n').flatMap((line, i) => {
    const shown = [...line.matchAll(PLOT)]
      .map(([, name]) => name)
      .filter((name) => values.has(name))
      .map((name) => valueText(/** @type {number} */ (values.get(name))));
    return shown.length > 0 ? [{ line: i + 1, text: shown.join(', ') }] : [];
  });
}

/** @param {number} value @returns {string} the value with few enough digits to be readable while it changes */
export function valueText(value) {
  return Number.isInteger(value) ? String(value) : Number(value.toPrecision(4)).toString();
}
