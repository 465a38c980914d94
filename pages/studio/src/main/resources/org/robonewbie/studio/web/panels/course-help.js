/** Help for an exercise: hints that are revealed one by one, and a solution after several attempts. */
import { answer } from '../live/server.js';
import { hintButton, solutionButton } from '../state/course.js';
import { button, element, setText } from './elements.js';

/** @typedef {import('../state/course.js').Help} Help */

export class CourseHelp {
  #exercise = '';
  #hints = element('ol', { id: 'course-open-hints' });
  #next = button('', 'Opens the next hint of the worksheet', () => this.#open('hint'));
  #solve = button('', 'Shows one way to solve the exercise', () => this.#open('solution'));
  #program = element('pre', { id: 'course-solution', hidden: '' });
  element = element(
    'div',
    { class: 'help' },
    this.#hints,
    element('div', { class: 'scene-line' }, this.#next, this.#solve),
    this.#program,
  );

  constructor() {
    this.#next.id = 'course-next-hint';
    this.#solve.id = 'course-show-solution';
    this.#next.hidden = true;
    this.#solve.hidden = true;
  }

  /** @param {string} exercise exercise whose help is shown */
  async show(exercise) {
    if (exercise !== this.#exercise) {
      this.#program.hidden = true;
    }
    this.#exercise = exercise;
    this.#draw(await answer('GET course/NAME/help', { NAME: exercise }));
  }

  /** @param {'hint' | 'solution'} what */
  async #open(what) {
    const request = what === 'hint' ? 'POST course/NAME/hint' : 'POST course/NAME/solution';
    const opened = await answer(request, { NAME: this.#exercise }).catch((error) => error.message);
    if (typeof opened === 'string') {
      setText(this.#program, opened);
      this.#program.hidden = false;
    } else {
      this.#draw(opened);
    }
  }

  /** @param {Help} help */
  #draw(help) {
    this.#hints.replaceChildren(...help.hints.map((hint) => element('li', {}, hint)));
    setText(this.#next, hintButton(help));
    this.#next.hidden = hintButton(help) === '';
    setText(this.#solve, solutionButton(help));
    this.#solve.hidden = !help.solution;
    this.#solve.toggleAttribute('disabled', help.triesLeft > 0);
  }
}
