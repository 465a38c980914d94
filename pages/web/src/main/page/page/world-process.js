/** The worker in which the world of this page runs; it begins to load as soon as this script is read. */
import { isBrowserNewEnough } from './old-browser.js';

/** Only the larger of the two programs of this page can carry out what people write. */
const NEEDS_PROGRAMS = ['program', 'exercise'];

/** @param {'field' | 'programs'} name of the program that is wanted @returns {Worker} */
const begin = (name) => new Worker('world-worker.js', { type: 'module', name });

export class World {
  #worker = begin('field');
  /** @type {Worker | undefined} that can carry out programs */
  #prepared;
  /** @type {(event: MessageEvent) => void} */
  #hear = () => {};
  /** @type {(event: ErrorEvent) => void} */
  #fail = () => {};
  /** The motions of this browser, which programs may start: name and bytes of each. @type {() => [string, Int8Array][]} */
  ownMotions = () => [];
  /** Called when another worker has taken the place of the first. */
  moved = () => {};

  /** @param {(event: MessageEvent) => void} hear @param {(event: ErrorEvent) => void} fail */
  listen(hear, fail) {
    this.#hear = hear;
    this.#fail = fail;
    this.#attach();
  }

  /** Begins to load what programs need, while somebody reads or writes one. */
  prepare() {
    this.#prepared ??= begin('programs');
  }

  /** @param {object} data a action of the worker, and what it needs */
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
    this.#worker.onmessage = this.#hear;
    this.#worker.onerror = this.#fail;
  }
}

export const world = isBrowserNewEnough() ? new World() : undefined;
