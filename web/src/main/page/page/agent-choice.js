/** Which of the shipped agents plays: a list in the bar of the page, and a button that begins once more. */
import { button, element, setEntries } from '../panels/elements.js';

const FIRST = 'Agent_BetterSoccer';

export class AgentChoice {
  /** @type {(agent: string) => void} */
  #begin = () => {};

  /** @param {string | null} wanted by the page's address */
  constructor(wanted) {
    this.chosen = wanted ?? FIRST;
    this.list = element('select', {
      id: 'page-agent',
      'aria-label': 'Agent that plays',
    });
    this.list.addEventListener('change', () => this.#take(this.list.value));
    const again = button('From the start', 'Begins once more with a new world', () => this.#take(this.chosen), {
      id: 'page-again',
    });
    document.querySelector('.bar-end')?.prepend(this.list, again);
  }

  /** @param {(agent: string) => void} begin lets an agent play in a new world */
  whenTaken(begin) {
    this.#begin = begin;
  }

  /** @param {readonly string[]} agents */
  offer(agents) {
    setEntries(
      this.list,
      agents.map((name) => [name, name]),
    );
    this.list.value = this.chosen;
  }

  /** @param {string} agent */
  #take(agent) {
    this.chosen = agent;
    this.#begin(agent);
  }
}
