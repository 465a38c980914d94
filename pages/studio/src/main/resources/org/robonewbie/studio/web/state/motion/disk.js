/**
 * The open motion against its file, which other programs may change at the same time. Pure.
 *
 * @typedef {import('./editor-state.js').EditorState} EditorState
 */
import { isUnsaved } from './editor-state.js';

/**
 * Says whether a file that has changed on the disk can be taken at once, or whether the person must decide.
 *
 * @param {EditorState} state
 * @param {Array<{name: string, version: string}>} files on the disk
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
