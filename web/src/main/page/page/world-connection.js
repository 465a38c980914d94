/** The line to a world in a worker of this page: the sibling of the line over a WebSocket in `live/connection.js`. */

const SEED = 1;

export class WorldConnection {
  /**
   * @param {Worker} worker
   * @param {import('../live/connection.js').Listener} listener
   * @param {import('./agent-choice.js').AgentChoice} choice
   * @param {import('./program-server.js').ProgramServer} programs
   */
  constructor(worker, listener, choice, programs) {
    this.programs = programs;
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
    this.programs.forget();
    this.worker.postMessage({ begin: { agent, seed: SEED } });
  }

  /** @param {any} data a text, the bytes of a state, or what the worker says of itself */
  #receive(data) {
    if (typeof data === 'string') {
      this.listener.told(JSON.parse(data));
    } else if (data instanceof ArrayBuffer) {
      this.listener.frameArrived(data);
    } else if ('begun' in data) {
      this.choice.offer(data.agents);
      this.listener.opened();
    } else if ('run' in data) {
      this.programs.heard(data.run);
    } else if ('refusal' in data) {
      this.programs.refused(data.refusal);
    } else {
      this.#fail(data.failure);
    }
  }

  /** @param {string} reason */
  #fail(reason) {
    this.listener.refused(`The simulator of this page has failed: ${reason}. Load the page again.`);
  }
}
