/** The rooms of the studio. Only rooms that one can enter are listed. */
import { byId, element } from './elements.js';

/** @type {Array<{name: string, fragment: string}>} */
const ROOMS = [{ name: 'Field', fragment: '#field' }];

export function roomsPanel() {
  byId('rooms').append(
    ...ROOMS.map(({ name, fragment }) => element('a', { href: fragment, 'aria-current': 'page' }, name)),
  );
}
