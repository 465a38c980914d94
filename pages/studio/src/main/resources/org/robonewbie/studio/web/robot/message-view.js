/** Raw messages between a robot and the simulator, as a collapsible and searchable tree. */
import { element, setText } from '../panels/elements.js';
import { readExpressions, writeExpression } from '../state/robot/expressions.js';

/** @typedef {import('../state/robot/expressions.js').Expression} Expression */

/**
 * @param {HTMLElement} place
 * @returns {(exchange: import('../state/robot/robot-memory.js').Exchange | undefined) => void}
 */
export function messageView(place) {
  const search = element('input', {
    type: 'search',
    id: 'message-search',
    placeholder: 'Search, for example GYR',
    'aria-label': 'Search in the messages',
  });
  const from = element('div', { class: 'message', id: 'perceptor-message' });
  const to = element('div', { class: 'message', id: 'effector-message' });
  place.append(search, element('h3', {}, 'From the simulator'), from, element('h3', {}, 'To the simulator'), to);
  /** Expanded parts, by name. @type {Set<string>} */
  const unfolded = new Set(['GYR', 'ACC', 'GS', 'time']);
  let drawn = '';
  return (exchange) => {
    const key = `${exchange?.seconds}\n${search.value}`;
    if (key === drawn || place.hidden) {
      return;
    }
    drawn = key;
    draw(from, exchange?.perceptors ?? '', search.value, unfolded);
    draw(to, exchange?.effectors ?? '', search.value, unfolded);
  };
}

/** @param {HTMLElement} place @param {string} message @param {string} wanted @param {Set<string>} unfolded */
function draw(place, message, wanted, unfolded) {
  const found = readExpressions(message).filter((each) =>
    writeExpression(each).toLowerCase().includes(wanted.toLowerCase()),
  );
  if (message === '' || found.length === 0) {
    setText(place, message === '' ? 'no message at this moment' : 'nothing found');
    return;
  }
  place.replaceChildren(...found.map((each) => tree(each, wanted, unfolded)));
}

/** @param {Expression} expression @param {string} wanted @param {Set<string>} unfolded @returns {HTMLElement} */
function tree(expression, wanted, unfolded) {
  const text = writeExpression(expression);
  if (
    typeof expression === 'string' ||
    text.length < 64 ||
    !expression.some((each) => typeof each !== 'string' && each.length > 0)
  ) {
    return element('div', {}, text);
  }
  const name = String(expression[0]);
  const inner = expression.filter((each) => typeof each !== 'string');
  const words = expression.filter((each) => typeof each === 'string').join(' ');
  const summary = element('summary', {}, `(${words} … ${inner.length} parts)`);
  const folder = element('details', {}, summary);
  folder.open = unfolded.has(name) || (wanted !== '' && !name.toLowerCase().includes(wanted.toLowerCase()));
  folder.addEventListener('toggle', () => (folder.open ? unfolded.add(name) : unfolded.delete(name)));
  const shown =
    wanted !== '' && folder.open
      ? inner.filter((each) => writeExpression(each).toLowerCase().includes(wanted.toLowerCase()))
      : inner;
  folder.append(...(shown.length > 0 ? shown : inner).map((each) => tree(each, wanted, unfolded)));
  return folder;
}
