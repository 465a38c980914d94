/** Unlimited undo history. Pure: each change returns a new history. */

/**
 * @template T
 * @typedef {object} Step
 * @property {T} value
 * @property {string} label label of the change
 */

/**
 * @template T
 * @typedef {object} History
 * @property {readonly Step<T>[]} past
 * @property {Step<T>} present
 * @property {readonly Step<T>[]} future
 * @property {string} gesture changes of one gesture form one step; empty for none
 */

/**
 * @template T
 * @param {T} value
 * @returns {History<T>}
 */
export function historyOf(value) {
  return { past: [], present: { value, label: '' }, future: [], gesture: '' };
}

/**
 * @template T
 * @param {History<T>} history
 * @param {T} value
 * @param {string} label
 * @param {string} [gesture] gesture such as one drag of the mouse
 * @returns {History<T>}
 */
export function changed(history, value, label, gesture = '') {
  if (value === history.present.value) {
    return history;
  }
  const continues = gesture !== '' && gesture === history.gesture;
  return {
    past: continues ? history.past : [...history.past, history.present],
    present: { value, label },
    future: [],
    gesture,
  };
}

/**
 * @template T
 * @param {History<T>} history
 * @returns {History<T>}
 */
export function undone(history) {
  const before = history.past.at(-1);
  if (!before) {
    return history;
  }
  return {
    past: history.past.slice(0, -1),
    present: before,
    future: [history.present, ...history.future],
    gesture: '',
  };
}

/**
 * @template T
 * @param {History<T>} history
 * @returns {History<T>}
 */
export function redone(history) {
  const [after, ...future] = history.future;
  return after ? { past: [...history.past, history.present], present: after, future, gesture: '' } : history;
}
