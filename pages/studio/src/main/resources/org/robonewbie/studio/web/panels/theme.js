/** Light or dark theme: follows the system until the user chooses. */
import { keepText, recallText } from './memory.js';
import { byId } from './elements.js';

/** @typedef {'light' | 'dark'} Theme */

const KEY = 'robonewbie-theme';

/**
 * @param {string | null} forced theme given in the page's address
 * @param {(theme: Theme) => void} changed
 */
export function themeSwitch(forced, changed) {
  const system = window.matchMedia('(prefers-color-scheme: dark)');
  const button = byId('theme-button');
  let choice = forced ?? recallText(KEY);
  const apply = () => {
    /** @type {Theme} */
    const theme = choice === 'light' || choice === 'dark' ? choice : system.matches ? 'dark' : 'light';
    document.documentElement.dataset.theme = theme;
    button.textContent = theme === 'dark' ? 'Light' : 'Dark';
    button.title = `Switch to ${theme === 'dark' ? 'light' : 'dark'} colours`;
    changed(theme);
  };
  button.addEventListener('click', () => {
    choice = document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark';
    keepText(KEY, choice);
    apply();
  });
  system.addEventListener('change', apply);
  apply();
}
