/** The line to a world in a worker of this page: the sibling of the line over a WebSocket in `live/connection.js`. */

const SEED = 1;

export class WorldConnection {
  /**
   * @param {Worker} worker
   * @param {import('../live/connection.js').Listener} listener
   * @param {import('./agent-choice.js').AgentChoice} choice
   */
  constructor(worker, listener, choice) {
    this.listener = listener;
    this.choice = choice;
    this.worker = worker;
    this.worker.onmessage = ({ data }) => this.#receive(data);
    this.worker.onerror = (event) => this.#fail(event.message);
    choice.whenTaken((agent) => this.#begin(agent));
  }

  open() {
    this.#begin(this.choice.chosen);
  }

  /** @param {object} command such as `{do: 'pause'}` */
  send(command) {
    this.worker.postMessage({ ask: command });
  }

  /** A worker of the same page does not fall silent by itself. */
  checkSilence() {}

  /** @param {string} agent */
  #begin(agent) {
    this.worker.postMessage({ begin: { agent, seed: SEED } });
  }

  /** @param {string | ArrayBuffer | {begun: string, agents: string[]} | {failure: string}} data */
  #receive(data) {
    if (typeof data === 'string') {
      this.listener.told(JSON.parse(data));
    } else if (data instanceof ArrayBuffer) {
      this.listener.frameArrived(data);
    } else if ('begun' in data) {
      this.choice.offer(data.agents);
      this.listener.opened();
    } else {
      this.#fail(data.failure);
    }
  }

  /** @param {string} reason */
  #fail(reason) {
    this.listener.refused(`The simulator of this page has failed: ${reason}. Load the page again.`);
  }
}
