/** Getting-started list: three things to try; each is crossed out when done, and the list disappears for good after the last one. */
import { button, byId, element } from './elements.js';
import { keep, recall } from './memory.js';

const KEY = 'robonewbie-first-steps';

/** @typedef {'ball' | 'puppet' | 'motion'} Step */

/** @type {Array<{step: Step, text: string}>} */
const STEPS = [
  { step: 'ball', text: 'Drag the ball somewhere else' },
  { step: 'puppet', text: 'Add a puppet (under Tools), then hold W to make it walk' },
  { step: 'motion', text: 'Edit a motion in the Motion room (above)' },
];

export class FirstSteps {
  /** @type {Set<string>} */
  #done = new Set(recall(KEY, /** @type {string[]} */ ([])));
  #hasPuppets = true;

  constructor() {
    this.place = byId('first-steps');
    this.items = STEPS.map(({ step, text }) => element('li', { 'data-step': step }, text));
    const close = button('Got it', 'Hides this list permanently', () => this.#finish());
    this.place.append(element('h2', {}, 'Try this'), element('ol', {}, ...this.items), close);
    this.#draw();
  }

  /** @param {Step} step */
  done(step) {
    if (!this.#done.has(step)) {
      this.#keep([...this.#done, step]);
    }
  }

  /** Leaves out the puppet where there are none, as at a watched server. @param {import('../state/studio-state.js').StudioState} state */
  show({ scene }) {
    const hasPuppets = scene?.puppets === true;
    if (scene && hasPuppets !== this.#hasPuppets) {
      this.#hasPuppets = hasPuppets;
      this.#draw();
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
    this.items.forEach((item) => {
      item.classList.toggle('done', this.#done.has(item.dataset.step ?? ''));
      item.hidden = !this.#isOffered(item.dataset.step);
    });
    this.place.hidden = STEPS.every(({ step }) => this.#done.has(step) || !this.#isOffered(step));
  }

  /** @param {string} [step] */
  #isOffered(step) {
    return this.#hasPuppets || step !== 'puppet';
  }
}
