import { PANEL_TITLES } from '../state/layout.js';
import { byId, element } from './elements.js';

/**
 * Adds a panel to a room.
 *
 * @param {'robot' | 'program'} room
 * @param {import('../state/layout.js').PanelName} name
 */
export function sidePanel(room, name) {
  const title = PANEL_TITLES[name];
  const inside = element('div', { class: 'panel-inside', id: `${room}-${name}` });
  const head = element('h2', { class: 'panel-title' }, title);
  byId(`${room}-room`).append(
    element('section', { class: 'side-panel', 'data-panel': name, 'aria-label': title }, head, inside),
  );
  return inside;
}
