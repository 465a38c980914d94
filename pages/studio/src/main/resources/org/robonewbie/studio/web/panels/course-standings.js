/** Progress in the whole course: exercises, points, time, badges, and the teacher's table. */
import { button, element, offer, setText } from './elements.js';

/** @typedef {import('../state/course.js').Standings} Standings */

export class CourseStandings {
  #csv = '';
  #sum = element('p', { id: 'course-sum' });
  #badges = element('p', { id: 'course-badges' });
  element = element(
    'div',
    { class: 'standings' },
    this.#sum,
    this.#badges,
    button('Save for my teacher', 'Saves your progress as a table (CSV)', () => this.#save()),
  );

  /** @param {Standings} standings */
  show({ sum, badges, csv }) {
    this.#csv = csv;
    setText(this.#sum, sum);
    this.#badges.replaceChildren(...badges.map((badge) => element('span', { class: 'badge' }, badge)));
  }

  #save() {
    offer('progress.csv', this.#csv, 'text/csv');
  }
}
