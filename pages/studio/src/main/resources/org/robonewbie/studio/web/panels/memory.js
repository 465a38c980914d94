/** What the browser remembers for its user. A page that is a file may have no memory: then choices hold until it is closed. */

/**
 * @template T
 * @param {string} key
 * @param {T} otherwise what holds as long as nothing is remembered
 * @returns {T}
 */
export function recall(key, otherwise) {
  try {
    return JSON.parse(recallText(key) ?? 'null') ?? otherwise;
  } catch {
    return otherwise;
  }
}

/** @param {string} key @returns {string | null} a text as it was remembered */
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
    // The choice holds until the page is closed.
  }
}

/** @param {string} key @param {unknown} value */
export function keep(key, value) {
  keepText(key, JSON.stringify(value));
}
