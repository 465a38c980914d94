/** Request-response calls to the program in the world's worker. */

export class WorldQuestions {
  #asked = 0;
  /** @type {Map<number, {message: object, done: (result: any) => void}>} */
  #waiting = new Map();

  /** @param {import('./world-process.js').World} world */
  constructor(world) {
    this.world = world;
    world.moved = () => this.#repeatRequests();
  }

  /** @param {string} name name of a function of the program @param {...unknown} args @returns {Promise<any>} its result */
  ask(name, ...args) {
    return this.#send('call', { name, args });
  }

  /**
   * @param {string} request request that starts an exercise
   * @param {Int8Array[]} classes classes of the program
   * @returns {Promise<string>} its result
   */
  begin(request, classes) {
    return this.#send('exercise', { request, classes });
  }

  /** @param {string} action action of the worker @param {object} data @returns {Promise<any>} */
  #send(action, data) {
    this.#asked += 1;
    const id = this.#asked;
    const message = { [action]: { id, ...data } };
    this.world.postMessage(message);
    return new Promise((done) => {
      this.#waiting.set(id, { message, done });
    });
  }

  /** @param {{id: number, result: any}} answer */
  answered({ id, result }) {
    this.#waiting.get(id)?.done(result);
    this.#waiting.delete(id);
  }

  /** Resends the unanswered requests to the new worker. */
  #repeatRequests() {
    for (const { message } of this.#waiting.values()) {
      this.world.postMessage(message);
    }
  }
}
