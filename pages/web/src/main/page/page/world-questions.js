/** Request-response calls to the program in the world's worker. */

export class WorldQuestions {
  #asked = 0;
  /** @type {Map<number, {call: object, done: (result: any) => void}>} */
  #waiting = new Map();

  /** @param {import('./world-process.js').World} world */
  constructor(world) {
    this.world = world;
    world.moved = () => this.#repeatRequests();
  }

  /** @param {string} name name of a function of the program @param {...unknown} args @returns {Promise<any>} its result */
  ask(name, ...args) {
    this.#asked += 1;
    const call = { id: this.#asked, name, args };
    this.world.postMessage({ call });
    return new Promise((done) => {
      this.#waiting.set(call.id, { call, done });
    });
  }

  /** @param {{id: number, result: any}} answer */
  answered({ id, result }) {
    this.#waiting.get(id)?.done(result);
    this.#waiting.delete(id);
  }

  /** Repeats the unanswered requests to a new worker. */
  #repeatRequests() {
    for (const { call } of this.#waiting.values()) {
      this.world.postMessage({ call });
    }
  }
}
