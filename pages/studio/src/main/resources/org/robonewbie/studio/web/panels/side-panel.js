import { PANEL_TITLES } from '../state/layout.js';
import { button, byId, element } from './elements.js';

/**
 * Adds a panel to a room, below a title that collapses it.
 *
 * @param {'robot' | 'program'} room
 * @param {import('../state/layout.js').PanelName} name
 * @param {(panel: import('../state/layout.js').PanelName) => void} fold
 */
export function sidePanel(room, name, fold) {
  const title = PANEL_TITLES[name];
  const look = { class: 'panel-title', 'aria-expanded': 'true' };
  const head = button(title, 'Collapse or expand', () => fold(name), look);
  const inside = element('div', { class: 'panel-inside', id: `${room}-${name}` });
  const made = element('section', { class: 'side-panel', 'data-panel': name, 'aria-label': title }, head, inside);
  byId(`${room}-room`).append(made);
  return inside;
}
