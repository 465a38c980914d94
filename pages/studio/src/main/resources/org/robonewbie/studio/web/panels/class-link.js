/** For teachers: chooses exercises and trials for a class, and creates the link that its pupils open in the web edition. */
import { classHash } from '../state/class-link.js';
import { button, choice, element, setText } from './elements.js';
import { keep, recall } from './memory.js';

const ADDRESS = 'robonewbie-class-address';
const TRIALS = /** @type {const} */ ([
  ['1', '1 trial'],
  ['3', '3 trials'],
  ['10', '10 trials'],
]);

export class ClassLink {
  #list = element('ul', { class: 'class-exercises' });
  #trials = choice({ id: 'class-trials', 'aria-label': 'Trials of each program' }, TRIALS, () => this.#show());
  #address = element('input', { type: 'text', id: 'class-address', 'aria-label': 'Address of the web edition' });
  #link = element('input', { type: 'text', id: 'class-link', readonly: '', 'aria-label': 'Link for the class' });
  #copied = element('span', { class: 'faint', role: 'status' });
  element = element(
    'details',
    { id: 'class-choice' },
    element('summary', {}, 'For teachers: a class without accounts'),
    element(
      'p',
      {},
      'Choose exercises. Pupils open the link, solve them in their browser and send you one link or file.',
    ),
    this.#list,
    element('label', { class: 'class-address' }, 'Address of the web edition', this.#address),
    element(
      'div',
      { class: 'scene-line' },
      this.#trials,
      button('Copy link', 'Copies the link', () => this.#copy()),
    ),
    this.#link,
    this.#copied,
  );

  constructor() {
    this.#trials.value = '3';
    this.#address.value = recall(ADDRESS, new URL('.', location.href).href);
    this.#address.addEventListener('input', () => {
      keep(ADDRESS, this.#address.value);
      this.#show();
    });
    this.#list.addEventListener('change', () => this.#show());
    this.#show();
  }

  /** @param {import('../state/course.js').Lesson[]} lessons all exercises */
  show(lessons) {
    if (this.#list.childElementCount !== lessons.length) {
      this.#list.replaceChildren(
        ...lessons.map(({ name, number, title }) =>
          element(
            'li',
            {},
            element(
              'label',
              { class: 'check' },
              element('input', { type: 'checkbox', value: name }),
              `${number} ${title}`,
            ),
          ),
        ),
      );
    }
  }

  #show() {
    const boxes = [...this.#list.querySelectorAll('input')];
    const exercises = boxes.filter(({ checked }) => checked).map(({ value }) => value);
    const hash = classHash({ exercises, seeds: Number(this.#trials.value) });
    this.#link.value = exercises.length === 0 ? '' : `${this.#address.value.trim().replace(/#.*/, '')}${hash}`;
    setText(this.#copied, exercises.length === 0 ? 'No exercise is chosen yet.' : '');
  }

  async #copy() {
    if (this.#link.value !== '') {
      this.#link.select();
      const copied = await navigator.clipboard?.writeText(this.#link.value).then(
        () => true,
        () => false,
      );
      setText(this.#copied, copied ? 'Copied.' : 'Press Control-C to copy the selected link.');
    }
  }
}
