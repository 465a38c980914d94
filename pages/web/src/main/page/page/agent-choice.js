/** Toolbar elements for choosing the example agents that play: two lists and a restart button. */
import { button, choice, setEntries } from '../panels/elements.js';

const FIRST = 'Agent_BetterSoccer';
const MAX_OTHERS = 3;

export class AgentChoice {
  /** @type {() => void} */
  #begin = () => {};
  /** @type {(agent: string) => void} */
  #join = () => {};

  /** @param {readonly string[]} wanted agents requested in the page's address; empty names are ignored */
  constructor(wanted) {
    const [first = FIRST, ...others] = wanted.filter(Boolean);
    this.chosen = first;
    /** Agents that play alongside the selected one or the user's program. */
    this.others = others.slice(0, MAX_OTHERS);
    this.list = choice({ id: 'page-agent', 'aria-label': 'Playing agent' }, [], (agent) => this.#take(agent));
    const title = 'Adds an agent, up to four in total; the second and fourth play against the first and third';
    this.more = choice({ id: 'page-more', title, 'aria-label': title }, [], (agent) => agent && this.#add(agent));
    const again = button('⟲', 'Restarts with a new world', () => this.#begin(), {
      id: 'page-again',
      'aria-label': 'Restart',
    });
    document.querySelector('.bar-end')?.prepend(this.list, this.more, again);
  }

  /** All agents that play if the user has no program on the pitch. @returns {string[]} */
  get all() {
    return [this.chosen, ...this.others];
  }

  /** @param {() => void} begin starts all agents in a new world @param {(agent: string) => void} join adds an agent */
  onChoice(begin, join) {
    this.#begin = begin;
    this.#join = join;
  }

  /** @param {readonly string[]} agents @param {string} [playing] the agent that is playing; empty for a program or an empty pitch */
  offer(agents, playing = '') {
    const entries = agents.map((name) => /** @type {[string, string]} */ ([name, name]));
    setEntries(this.list, entries);
    this.list.value = playing;
    setEntries(this.more, [['', '+ Robot'], ...entries]);
    this.#draw();
  }

  #draw() {
    this.more.value = '';
    this.more.disabled = this.others.length >= MAX_OTHERS;
  }

  /** @param {string} agent the only player */
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
