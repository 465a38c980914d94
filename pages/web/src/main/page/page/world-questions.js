/** Questions to the program in the world's worker, each with its answer. */

export class WorldQuestions {
  #asked = 0;
  /** @type {Map<number, {call: object, done: (result: any) => void}>} */
  #waiting = new Map();

  /** @param {import('./world-process.js').World} world */
  constructor(world) {
    this.world = world;
    world.moved = () => this.#askAgain();
  }

  /** @param {string} name of a function of the program @param {...unknown} given @returns {Promise<any>} what it returns */
  ask(name, ...given) {
    this.#asked += 1;
    const call = { id: this.#asked, name, given };
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

  /** Another worker is there, which has not heard what the one before did not answer. */
  #askAgain() {
    for (const { call } of this.#waiting.values()) {
      this.world.postMessage({ call });
    }
  }
}
