/** Time line of the running simulation, shared by all rooms, with a button that returns to the present. */
import { CYCLE_SECONDS } from '../state/cycle.js';
import { button, byId, element, setText } from './elements.js';

/** @typedef {import('../state/time-cursor.js').TimeCursor} TimeCursor */

/**
 * @param {TimeCursor} cursor
 * @param {() => void} changed
 * @returns {(tense: 'live' | 'past' | 'recorded', isHidden: boolean) => void} function that updates the line
 */
export function timeLinePanel(cursor, changed) {
  const place = byId('time-line');
  const line = element('input', {
    type: 'range',
    id: 'moment',
    'aria-label': 'Shown moment',
    title: 'Go back in time; the simulation continues',
  });
  const reading = element('span', { class: 'moment-reading', role: 'status' });
  const live = button('Live', 'Return to the present (End)', () => act(() => cursor.goLive()));
  live.id = 'go-live';
  place.append(live, line, reading);
  /** @param {() => void} action */
  const act = (action) => {
    action();
    changed();
  };
  line.addEventListener('input', () => act(() => cursor.goTo(Number(line.value))));
  return (tense, isHidden) => {
    const { first, last, kept } = cursor.history;
    place.hidden = isHidden;
    place.dataset.tense = tense;
    line.hidden = tense === 'recorded';
    line.disabled = kept.length < 2;
    line.min = String(first);
    line.max = String(last);
    line.value = String(cursor.cycle ?? last);
    live.setAttribute('aria-pressed', String(tense === 'live'));
    setText(reading, readingOf(cursor));
  };
}

/** @param {TimeCursor} cursor */
function readingOf({ cycle, recorded, history }) {
  if (recorded) {
    return `Recording ${recorded.name} at ${(recorded.frame.cycle * CYCLE_SECONDS).toFixed(2)} s`;
  }
  return cycle === undefined
    ? 'now'
    : `${(cycle * CYCLE_SECONDS).toFixed(2)} s, ${((history.last - cycle) * CYCLE_SECONDS).toFixed(1)} s ago`;
}

/**
 * @param {TimeCursor} cursor
 * @param {() => void} changed
 * @returns {import('./keys.js').Action[]} key actions of the time line
 */
export function timeLineActions(cursor, changed) {
  const go = (/** @type {() => void} */ action) => () => (action(), changed());
  return [
    { keys: ['<', ';'], shown: '<', text: 'back in time; the simulation continues', act: go(() => cursor.step(-5)) },
    { keys: ['>', ':'], shown: '>', text: 'forward in time', act: go(() => cursor.step(5)) },
    { keys: ['End'], shown: 'End', text: 'back to the present', act: go(() => cursor.goLive()) },
  ];
}
