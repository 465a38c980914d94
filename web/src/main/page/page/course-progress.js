/** How far somebody is with the exercises; the browser keeps it. */

const KEY = 'robonewbie-page-progress';
const MOST_POINTS = 10;
const PAUSE_MILLISECONDS = 20 * 60 * 1000;

/**
 * @typedef {{tries: number, best: number, passed: boolean, milliseconds: number, hints: number, seenAt: number}} State
 * @typedef {import('../state/course.js').Lesson} Lesson
 */

/** @type {State} */
const NEW = { tries: 0, best: 0, passed: false, milliseconds: 0, hints: 0, seenAt: 0 };

export class CourseProgress {
  /** @param {string} exercise @returns {import('../state/course.js').Standing} */
  standing(exercise) {
    const { tries, best, passed, milliseconds } = this.#of(exercise);
    return { tries, best, passed, minutes: Math.floor(milliseconds / 60_000) };
  }

  /** @param {string} exercise how many of its hints are open */
  hints(exercise) {
    return this.#of(exercise).hints;
  }

  /** @param {string} exercise @param {number} all how many hints there are */
  openHint(exercise, all) {
    this.#change(exercise, (state) => ({ ...state, hints: Math.min(all, state.hints + 1) }));
  }

  /** Somebody works at an exercise; pauses of more than 20 minutes do not count. @param {string} exercise */
  seen(exercise) {
    this.#change(exercise, worked);
  }

  /** @param {string} exercise @param {number} points @param {boolean} passed */
  tried(exercise, points, passed) {
    this.#change(exercise, (before) => {
      const state = worked(before);
      return {
        ...state,
        tries: state.tries + 1,
        best: Math.max(state.best, points),
        passed: state.passed || passed,
      };
    });
  }

  /** @param {readonly Lesson[]} lessons @returns {import('../state/course.js').Standings} */
  standings(lessons) {
    const passed = lessons.filter(({ standing }) => standing.passed).length;
    const points = lessons.reduce((sum, { standing }) => sum + standing.best, 0);
    const rows = lessons.map(({ name, standing }) =>
      [name, standing.tries, standing.best.toFixed(1), standing.passed, standing.minutes].join(','),
    );
    return {
      sum: `${passed} of ${lessons.length} exercises, ${points.toFixed(1)} of ${lessons.length * MOST_POINTS} points`,
      badges: [],
      csv: ['exercise,tries,points,passed,minutes', ...rows, ''].join('\n'),
    };
  }

  /** @returns {Record<string, State>} */
  get #all() {
    return JSON.parse(localStorage.getItem(KEY) ?? '{}');
  }

  /** @param {string} exercise */
  #of(exercise) {
    return this.#all[exercise] ?? NEW;
  }

  /** @param {string} exercise @param {(state: State) => State} deed */
  #change(exercise, deed) {
    localStorage.setItem(KEY, JSON.stringify({ ...this.#all, [exercise]: deed(this.#of(exercise)) }));
  }
}

/** @param {State} state @returns {State} */
function worked(state) {
  const now = Date.now();
  const gap = now - state.seenAt;
  const isWork = !state.passed && gap >= 0 && gap <= PAUSE_MILLISECONDS;
  return { ...state, milliseconds: state.milliseconds + (isWork ? gap : 0), seenAt: now };
}
