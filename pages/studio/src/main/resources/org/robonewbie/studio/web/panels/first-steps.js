/** Three things to try, for people who are here for the first time; each is crossed out once it is done, and then it is gone for good. */
import { button, byId, element } from './elements.js';
import { keep, recall } from './memory.js';

const KEY = 'robonewbie-first-steps';

/** @typedef {'ball' | 'puppet' | 'motion'} Step */

/** @type {Array<{step: Step, text: string}>} */
const STEPS = [
  { step: 'ball', text: 'Drag the ball somewhere else' },
  { step: 'puppet', text: 'Add a puppet (Tools), then hold W: it walks' },
  { step: 'motion', text: 'Shape a motion: the room Motion, above' },
];

export class FirstSteps {
  /** @type {Set<string>} */
  #done = new Set(recall(KEY, /** @type {string[]} */ ([])));

  constructor() {
    this.place = byId('first-steps');
    this.items = STEPS.map(({ step, text }) => element('li', { 'data-step': step }, text));
    const close = button('Got it', 'Takes this away for good', () => this.#finish());
    this.place.append(element('h2', {}, 'Try this'), element('ol', {}, ...this.items), close);
    this.#draw();
  }

  /** @param {Step} step */
  done(step) {
    if (!this.#done.has(step)) {
      this.#keep([...this.#done, step]);
    }
  }

  #finish() {
    this.#keep(STEPS.map(({ step }) => step));
  }

  /** @param {string[]} steps */
  #keep(steps) {
    this.#done = new Set(steps);
    keep(KEY, steps);
    this.#draw();
  }

  #draw() {
    this.items.forEach((item) => item.classList.toggle('done', this.#done.has(item.dataset.step ?? '')));
    this.place.hidden = STEPS.every(({ step }) => this.#done.has(step));
  }
}
