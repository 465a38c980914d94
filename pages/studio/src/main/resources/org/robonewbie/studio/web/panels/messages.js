/** What the studio says: a banner while nothing can be seen, and short notes. */
import { message } from '../state/studio-state.js';
import { byId, element, setText } from './elements.js';

/** @typedef {import('../state/studio-state.js').StudioState} StudioState */

const NOTE_MILLISECONDS = 6000;

/** @returns {(state: StudioState, now: number) => void} draws the banner */
export function banner() {
  return (state, now) => tell(message(state, now));
}

/**
 * Shows a message in the banner, or no banner at all.
 *
 * @param {import('../state/studio-state.js').Message | undefined} shown
 */
export function tell(shown) {
  const panel = byId('banner');
  panel.hidden = !shown;
  if (!shown) {
    return;
  }
  if (!panel.hasChildNodes()) {
    panel.append(
      element('span', { class: 'spinner', 'aria-hidden': 'true' }),
      element('div', {}, element('strong'), element('span')),
    );
  }
  panel.dataset.tone = shown.tone;
  const [title, text] = panel.querySelectorAll('div > *');
  setText(title, shown.title);
  setText(text, shown.text);
}

/** @returns {(text: string) => void} shows a note for some seconds */
export function notes() {
  const panel = byId('toast');
  let timer = 0;
  return (text) => {
    setText(panel, text);
    panel.hidden = false;
    clearTimeout(timer);
    timer = window.setTimeout(() => {
      panel.hidden = true;
    }, NOTE_MILLISECONDS);
  };
}

/** Says so when a script of this page fails. @param {(text: string) => void} note */
export function reportMistakes(note) {
  const report = (/** @type {unknown} */ what) => note(`This page has met an error: ${what}. Load it again.`);
  window.addEventListener('error', (event) => report(event.message));
  window.addEventListener('unhandledrejection', (event) => report(event.reason));
}
