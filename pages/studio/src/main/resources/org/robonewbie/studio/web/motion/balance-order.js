/** Balances a motion and reports the keyframes that cannot be balanced. */
import { balanceText, madeBalanced } from '../state/motion/balancing.js';
import { selected } from '../state/motion/editor-state.js';
import { showFindings } from '../panels/questions.js';

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
  showFindings('Balance', `${text} These keyframes were not changed:`, places);
}
