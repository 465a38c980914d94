/** Ghost of the previous trial of an exercise, shown alongside the current one. Pure. */
import { LiveHistory } from './live-history.js';

/**
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../live/state-frame.js').Frame} Frame
 * @typedef {import('../live/state-frame.js').Trial} Trial
 */

export class TrialGhost {
  /** The last finished trial of each task, and of each combination of task and seed. @type {Map<string, LiveHistory>} */
  #over = new Map();
  /** @type {Trial | undefined} */
  #trial;
  #running = new LiveHistory();
  /** Whether the ghost is switched on. */
  isOn = true;

  /** Records a frame of the running simulation. @param {number} cycle @param {Scene} scene @param {ArrayBuffer} bytes */
  receive(cycle, scene, bytes) {
    if (!isSame(scene.trial, this.#trial)) {
      this.#keep();
      this.#trial = scene.trial;
    }
    if (scene.trial) {
      this.#running.push(cycle, scene, bytes);
    }
  }

  #keep() {
    if (this.#trial) {
      const { task, seed } = this.#trial;
      this.#over.set(task, this.#running);
      this.#over.set(`${task} ${seed}`, this.#running);
    }
    this.#running = new LiveHistory();
  }

  /**
   * Returns the same moment of an earlier trial, preferably one with the same seed, which started identically.
   *
   * @param {Scene | undefined} scene @param {Frame | undefined} frame displayed moment
   * @returns {{scene: Scene, frame: Frame} | undefined}
   */
  beside(scene, frame) {
    const trial = scene?.trial;
    if (!this.isOn || !trial || !frame) {
      return undefined;
    }
    const last = this.#over.get(`${trial.task} ${trial.seed}`) ?? this.#over.get(trial.task);
    return last?.at(frame.cycle);
  }
}

/** @param {Trial | undefined} one @param {Trial | undefined} other */
function isSame(one, other) {
  return one?.task === other?.task && one?.attempt === other?.attempt && one?.seed === other?.seed;
}
