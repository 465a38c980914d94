/** Settings in the browser's local storage. A page opened from a file may have no storage; its settings then last until it is closed. */

/**
 * @template T
 * @param {string} key
 * @param {T} otherwise default value
 * @returns {T}
 */
export function recall(key, otherwise) {
  try {
    return JSON.parse(recallText(key) ?? 'null') ?? otherwise;
  } catch {
    return otherwise;
  }
}

/** @param {string} key @returns {string | null} the stored text */
export function recallText(key) {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

/** @param {string} key @param {string} text */
export function keepText(key, text) {
  try {
    localStorage.setItem(key, text);
  } catch {
    // The setting lasts until the page is closed.
  }
}

/** @param {string} key @param {unknown} value */
export function keep(key, value) {
  keepText(key, JSON.stringify(value));
}
