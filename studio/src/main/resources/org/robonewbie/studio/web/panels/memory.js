/** What the browser remembers for its user. A page that is a file may have no memory: then choices hold until it is closed. */

/**
 * @template T
 * @param {string} key
 * @param {T} otherwise what holds as long as nothing is remembered
 * @returns {T}
 */
export function recall(key, otherwise) {
  try {
    return JSON.parse(localStorage.getItem(key) ?? 'null') ?? otherwise;
  } catch {
    return otherwise;
  }
}

/** @param {string} key @param {unknown} value */
export function keep(key, value) {
  try {
    localStorage.setItem(key, JSON.stringify(value));
  } catch {
    // The choice holds until the page is closed.
  }
}
