/** Drop-down menu of buttons; on wide pages some menus are expanded inline. */
import { button, element } from '../panels/elements.js';

/**
 * @param {string} name
 * @param {'' | 'unfolding'} kind whether it is expanded on wide pages
 * @param {HTMLElement[]} buttons
 */
export function menu(name, kind, buttons) {
  const list = element('div', { class: 'menu-list', role: 'group', 'aria-label': name }, ...buttons);
  const place = element('div', { class: `menu ${kind}` });
  const show = (/** @type {boolean} */ open) => {
    place.classList.toggle('open', open);
    head.setAttribute('aria-expanded', String(open));
  };
  const head = button(`${name} ▾`, `Actions for ${name.toLowerCase()}`, () => show(!place.classList.contains('open')));
  head.className = 'menu-head';
  show(false);
  place.append(head, list);
  list.addEventListener('click', () => show(false));
  place.addEventListener('focusout', (event) => {
    if (!place.contains(/** @type {Node | null} */ (event.relatedTarget))) {
      show(false);
    }
  });
  place.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && place.classList.contains('open')) {
      event.stopPropagation();
      show(false);
      head.focus();
    }
  });
  return place;
}
