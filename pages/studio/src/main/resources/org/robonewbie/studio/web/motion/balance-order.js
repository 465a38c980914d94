/** Makes a motion balanced and says where that is not possible. */
import { balanceText, madeBalanced } from '../state/motion/balancing.js';
import { selected } from '../state/motion/editor-state.js';
import { tell } from './questions.js';

/** @param {import('./editor.js').Editor} editor */
export function makeBalanced(editor) {
  const { state, report } = madeBalanced(editor.state);
  editor.set(state);
  const text = balanceText(report);
  if (report.never.length === 0) {
    editor.listener.note(text);
    return;
  }
  const places = report.never.map(({ index, reason }) => ({
    text: `Keyframe ${index + 1}: ${reason}`,
    go: () => editor.apply((each) => selected(each, index)),
  }));
  tell('Make it balanced', `${text} These stay as they were:`, places);
}
