/** Questions to the program in the world's worker, each with its answer. */

export class WorldQuestions {
  #asked = 0;
  /** @type {Map<number, (result: any) => void>} */
  #waiting = new Map();

  /** @param {import('./world-process.js').World} world */
  constructor(world) {
    this.world = world;
  }

  /** @param {string} name of a function of the program @param {...unknown} given @returns {Promise<any>} what it returns */
  ask(name, ...given) {
    this.#asked += 1;
    const id = this.#asked;
    this.world.postMessage({ call: { id, name, given } });
    return new Promise((done) => {
      this.#waiting.set(id, done);
    });
  }

  /** @param {{id: number, result: any}} answer */
  answered({ id, result }) {
    this.#waiting.get(id)?.(result);
    this.#waiting.delete(id);
  }
}
