/** What has gone wrong in the robots' programs: it stays on the picture until it is read and taken away. */
import { button, byId, element } from './elements.js';

const MOST = 3;
const LONGEST = 300;

export class Mistakes {
  /** @param {(team: string, number: number) => void} look shows a robot from inside, with its log */
  constructor(look) {
    this.look = look;
    this.place = byId('mistakes');
    this.list = element('ul', {});
    const close = button('×', 'Take these away', () => this.clear(), {
      class: 'quiet',
      'aria-label': 'Take these away',
    });
    this.place.append(element('h2', {}, 'Mistakes of programs'), close, this.list);
  }

  clear() {
    this.list.replaceChildren();
    this.place.hidden = true;
  }

  /** @param {{team: string, number: number, level: string, text: string}} mistake */
  add({ team, number, level, text }) {
    const name = `${team} ${number}`.trim();
    const robot = button(name, 'See this robot with its log', () => this.look(team, number), { class: 'quiet' });
    const words = text.length > LONGEST ? `${text.slice(0, LONGEST)}…` : text;
    this.list.append(element('li', { class: level.toLowerCase() }, robot, ` ${words}`));
    while (this.list.children.length > MOST) {
      this.list.children[0].remove();
    }
    this.place.hidden = false;
  }
}
