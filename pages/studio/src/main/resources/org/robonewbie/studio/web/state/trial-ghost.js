/** The last trial of an exercise, to be seen beside the one that goes on. Pure. */
import { LiveHistory } from './live-history.js';

/**
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../live/state-frame.js').Frame} Frame
 * @typedef {import('../live/state-frame.js').Trial} Trial
 */

export class TrialGhost {
  /** The last trial that is over, by task and by task and seed. @type {Map<string, LiveHistory>} */
  #over = new Map();
  /** @type {Trial | undefined} */
  #trial;
  #running = new LiveHistory();
  /** Whether the person wants to see it. */
  isOn = true;

  /** Takes a frame of the running simulation. @param {number} cycle @param {Scene} scene @param {ArrayBuffer} bytes */
  hear(cycle, scene, bytes) {
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
   * What was to be seen at the same moment of the last trial: of the one with the same seed, which began alike, if there is one.
   *
   * @param {Scene | undefined} scene @param {Frame | undefined} frame the moment that is shown
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
