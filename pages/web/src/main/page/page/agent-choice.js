/** Which of the shipped agents play: two lists in the bar of the page, and a button that begins once more. */
import { button, choice, setEntries } from '../panels/elements.js';

const FIRST = 'Agent_BetterSoccer';
const MOST_OTHERS = 3;

export class AgentChoice {
  /** @type {() => void} */
  #begin = () => {};
  /** @type {(agent: string) => void} */
  #join = () => {};

  /** @param {readonly string[]} wanted by the page's address */
  constructor([first, ...others]) {
    this.chosen = first ?? FIRST;
    /** Those that play beside the chosen one, or beside one's own program. */
    this.others = others.slice(0, MOST_OTHERS);
    this.list = choice({ id: 'page-agent', 'aria-label': 'Agent that plays' }, [], (agent) => this.#take(agent));
    const title = 'Lets one more agent play; every second robot plays against the first one, and four are the most';
    this.more = choice({ id: 'page-more', title, 'aria-label': title }, [], (agent) => this.#add(agent));
    const again = button('⟲', 'From the start: begins once more with a new world', () => this.#begin(), {
      id: 'page-again',
      'aria-label': 'From the start',
    });
    document.querySelector('.bar-end')?.prepend(this.list, this.more, again);
  }

  /** All agents that play when nobody programs. @returns {string[]} */
  get all() {
    return [this.chosen, ...this.others];
  }

  /** @param {() => void} begin lets all agents play in a new world @param {(agent: string) => void} join lets one more play */
  whenTaken(begin, join) {
    this.#begin = begin;
    this.#join = join;
  }

  /** @param {readonly string[]} agents */
  offer(agents) {
    const entries = agents.map((name) => /** @type {[string, string]} */ ([name, name]));
    setEntries(this.list, entries);
    this.list.value = this.chosen;
    setEntries(this.more, [['', '+ Robot'], ...entries]);
    this.#draw();
  }

  #draw() {
    this.more.value = '';
    this.more.disabled = this.others.length >= MOST_OTHERS;
  }

  /** @param {string} agent plays alone */
  #take(agent) {
    this.chosen = agent;
    this.others = [];
    this.#begin();
  }

  /** @param {string} agent */
  #add(agent) {
    this.others = [...this.others, agent];
    this.#join(agent);
    this.#draw();
  }
}
