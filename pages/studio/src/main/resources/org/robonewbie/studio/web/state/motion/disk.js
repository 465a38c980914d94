/**
 * Compares the open motion with its file, which other programs may change. Pure.
 *
 * @typedef {import('./editor-state.js').EditorState} EditorState
 */
import { isUnsaved } from './editor-state.js';

/**
 * Decides whether a changed file can be reloaded immediately, or whether the user must choose.
 *
 * @param {EditorState} state
 * @param {Array<{name: string, version: string}>} files files on disk
 * @returns {'same' | 'reload' | 'ask' | 'gone'}
 */
export function judgeDisk(state, files) {
  if (state.version === '') {
    return 'same';
  }
  const found = files.find(({ name }) => name === state.name);
  if (!found) {
    return 'gone';
  }
  if (found.version === state.version) {
    return 'same';
  }
  return isUnsaved(state) ? 'ask' : 'reload';
}
