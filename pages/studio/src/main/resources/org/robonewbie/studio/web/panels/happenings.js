/** What has happened in the game lately: fouls and goals, shown below the score board for some seconds. */
import { foulText } from '../state/happenings.js';
import { byId, element } from './elements.js';

const SHOWN_MILLISECONDS = 6000;
const MOST = 4;

export class Happenings {
  constructor() {
    this.list = element('ul', { class: 'happenings', 'aria-live': 'polite' });
    byId('score-board').append(this.list);
  }

  /**
   * @param {string} event as the recording writes it, such as `foul CHARGING left 3`
   * @param {{left: string, right: string}} teams
   */
  add(event, teams) {
    this.tell(foulText(event, teams));
  }

  /** @param {string} text nothing is shown if it is empty */
  tell(text) {
    if (text) {
      const line = element('li', {}, text);
      this.list.append(line);
      while (this.list.children.length > MOST) {
        this.list.children[0].remove();
      }
      setTimeout(() => line.remove(), SHOWN_MILLISECONDS);
    }
  }
}
