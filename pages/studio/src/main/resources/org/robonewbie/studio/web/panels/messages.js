/** The studio's messages: a banner while there is nothing to display, and short notes. */
import { message } from '../state/studio-state.js';
import { byId, element, setText } from './elements.js';

/** @typedef {import('../state/studio-state.js').StudioState} StudioState */

const NOTE_MILLISECONDS = 6000;

/** @returns {(state: StudioState, now: number) => void} function that updates the banner */
export function banner() {
  return (state, now) => showBanner(message(state, now, byId('field-room').dataset.exercises === 'on'));
}

/**
 * Shows a message in the banner, or hides the banner.
 *
 * @param {import('../state/studio-state.js').Message | undefined} shown
 */
export function showBanner(shown) {
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

/** @returns {(text: string) => void} function that shows a note for a few seconds */
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

/** Shows a note when one of the page's scripts fails. @param {(text: string) => void} note */
export function reportMistakes(note) {
  const report = (/** @type {unknown} */ what) => note(`This page has failed: ${what}. Reload it.`);
  window.addEventListener('error', (event) => report(event.message));
  window.addEventListener('unhandledrejection', (event) => report(event.reason));
}
