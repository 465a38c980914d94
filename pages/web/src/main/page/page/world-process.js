/** The worker that runs this page's world; it starts loading as soon as this script is evaluated. */
import { isBrowserNewEnough } from './old-browser.js';

/** Actions that need the larger of the two worker programs, the one that executes user code. */
const NEEDS_PROGRAMS = ['program', 'exercise'];

/** @param {'field' | 'programs'} name name of the worker program @returns {Worker} */
const begin = (name) => new Worker('world-worker.js', { type: 'module', name });

export class World {
  #worker = begin('field');
  /** @type {Worker | undefined} worker that can execute user programs */
  #prepared;
  /** @type {(event: MessageEvent) => void} */
  #onMessage = () => {};
  /** @type {(event: ErrorEvent) => void} */
  #fail = () => {};
  /** The user's motions, which programs may start: name and bytes of each. @type {() => [string, Int8Array][]} */
  ownMotions = () => [];
  /** Called when another worker has replaced the first one. */
  moved = () => {};

  /** @param {(event: MessageEvent) => void} onMessage @param {(event: ErrorEvent) => void} fail */
  listen(onMessage, fail) {
    this.#onMessage = onMessage;
    this.#fail = fail;
    this.#attach();
  }

  /** Starts loading the worker for programs in the background. */
  prepare() {
    this.#prepared ??= begin('programs');
  }

  /** @param {object} data action of the worker with its arguments */
  postMessage(data) {
    if (NEEDS_PROGRAMS.some((name) => name in data)) {
      this.#move();
      this.#worker.postMessage({ motions: this.ownMotions() });
    }
    this.#worker.postMessage(data);
  }

  #move() {
    if (this.#worker === this.#prepared) {
      return;
    }
    this.prepare();
    this.#worker.terminate();
    this.#worker = this.#prepared ?? this.#worker;
    this.#attach();
    this.moved();
  }

  #attach() {
    this.#worker.onmessage = this.#onMessage;
    this.#worker.onerror = this.#fail;
  }
}

export const world = isBrowserNewEnough() ? new World() : undefined;
