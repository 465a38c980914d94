/** Recent game events: fouls and goals, shown below the scoreboard for a few seconds. */
import { byId, element } from './elements.js';

const SHOWN_MILLISECONDS = 6000;
const MAX_ENTRIES = 4;

export class EventList {
  constructor() {
    this.list = element('ul', { class: 'event-list', 'aria-live': 'polite' });
    byId('score-board').append(this.list);
  }

  /** @param {string} text ignored if empty */
  show(text) {
    if (text) {
      const line = element('li', {}, text);
      this.list.append(line);
      while (this.list.children.length > MAX_ENTRIES) {
        this.list.children[0].remove();
      }
      setTimeout(() => line.remove(), SHOWN_MILLISECONDS);
    }
  }
}
