/** Errors from the robots' programs, shown on top of the 3D view until they are dismissed or the program is replaced. */
import { button, byId, element } from './elements.js';

const MAX_ENTRIES = 3;
const MAX_CHARACTERS = 300;

export class DiagnosticsList {
  /** @param {(team: string, number: number) => void} look opens the robot room with this robot's log */
  constructor(look) {
    this.look = look;
    this.place = byId('diagnostics');
    this.list = element('ul', {});
    const close = button('×', 'Dismiss', () => this.clear(), {
      class: 'quiet',
      'aria-label': 'Dismiss',
    });
    this.place.append(element('h2', {}, 'Program errors'), close, this.list);
  }

  clear() {
    this.list.replaceChildren();
    this.place.hidden = true;
  }

  /** @param {{team: string, number: number, level: string, text: string}} diagnostic */
  add({ team, number, level, text }) {
    const name = `${team} ${number}`.trim();
    const robot = button(name, 'Show this robot with its log', () => this.look(team, number), { class: 'quiet' });
    const words = text.length > MAX_CHARACTERS ? `${text.slice(0, MAX_CHARACTERS)}…` : text;
    this.list.append(element('li', { class: level.toLowerCase() }, robot, ` ${words}`));
    while (this.list.children.length > MAX_ENTRIES) {
      this.list.children[0].remove();
    }
    this.place.hidden = false;
  }
}
