/** Progress in the exercises, stored by the browser. */
import { csvCell } from '../state/csv-cell.js';
import { storage } from './page-storage.js';

const KEY = 'robonewbie-page-progress';
const MAX_POINTS = 10;
const TRIES_BEFORE_SOLUTION = 3;
const MINUTES_PER_HOUR = 60;
const COLUMNS = ['name', 'exercise', 'passed', 'best points', 'tries', 'minutes', 'hints', 'solution seen', 'last'];
const PAUSE_MILLISECONDS = 20 * 60 * 1000;

/**
 * @typedef {{tries: number, best: number, passed: boolean, milliseconds: number, hints: number, solution?: boolean, seenAt: number}} State
 * @typedef {import('../state/course.js').Lesson & {fullName: string}} Lesson
 * @typedef {{title: string, counting: string[], needed: number, leastPoints: number, leastTries: number, alone: boolean}} Badge
 */

/** @type {State} */
const NEW = { tries: 0, best: 0, passed: false, milliseconds: 0, hints: 0, seenAt: 0 };

export class CourseProgress {
  /** State that the browser's storage cannot hold, kept until the page is closed. @type {Record<string, State>} */
  #open = {};

  /** @param {string} exercise @returns {import('../state/course.js').Standing} */
  standing(exercise) {
    const { tries, best, passed, milliseconds } = this.#of(exercise);
    return { tries, best, passed, minutes: Math.floor(milliseconds / 60_000) };
  }

  /** @param {string} exercise name of the exercise */
  hints(exercise) {
    return this.#of(exercise).hints;
  }

  /** @param {string} exercise @param {number} all number of hints */
  openHint(exercise, all) {
    this.#change(exercise, (state) => ({ ...state, hints: Math.min(all, state.hints + 1) }));
  }

  /** @param {string} exercise name of the exercise */
  triesBeforeSolution(exercise) {
    const { passed, tries } = this.#of(exercise);
    return passed ? 0 : Math.max(0, TRIES_BEFORE_SOLUTION - tries);
  }

  /** @param {string} exercise whose solution is shown */
  seeSolution(exercise) {
    this.#change(exercise, (state) => ({ ...state, solution: true }));
  }

  /** Adds working time to an exercise; pauses of more than 20 minutes do not count. @param {string} exercise */
  seen(exercise) {
    this.#change(exercise, worked);
  }

  /** @param {string} exercise @param {number} points @param {boolean} passed */
  tried(exercise, points, passed) {
    this.#change(exercise, (before) => {
      const state = worked(before);
      return { ...state, tries: state.tries + 1, best: Math.max(state.best, points), passed: state.passed || passed };
    });
  }

  /** @param {readonly Lesson[]} lessons @param {readonly Badge[]} badges @returns {import('../state/course.js').Standings} */
  standings(lessons, badges) {
    const states = lessons.map(({ name }) => this.#of(name));
    const passed = states.filter((state) => state.passed).length;
    const points = states.reduce((sum, { best }) => sum + best, 0);
    const work = time(states.reduce((sum, { milliseconds }) => sum + milliseconds, 0));
    return {
      sum: `${passed} of ${lessons.length} exercises passed, ${points.toFixed(1)} of ${lessons.length * MAX_POINTS} points, ${work}`,
      badges: badges.filter((badge) => this.#hasEarned(badge)).map(({ title }) => title),
      csv: [COLUMNS, ...lessons.map(({ name, fullName }) => row(fullName, this.#of(name)))]
        .map((cells) => `${cells.map(csvCell).join(',')}\r\n`)
        .join(''),
    };
  }

  /** @param {Badge} badge */
  #hasEarned({ counting, needed, leastPoints, leastTries, alone }) {
    const earned = counting.filter((exercise) => {
      const { passed, best, tries, hints, solution = false } = this.#of(exercise);
      const hadHelp = hints > 0 || solution;
      return passed && best >= leastPoints && tries >= leastTries && !(alone && hadHelp);
    });
    return earned.length >= needed;
  }

  /** @returns {Record<string, State>} */
  get #all() {
    return { ...JSON.parse(storage().get(KEY) ?? '{}'), ...this.#open };
  }

  /** @param {string} exercise */
  #of(exercise) {
    return this.#all[exercise] ?? NEW;
  }

  /** @param {string} exercise @param {(state: State) => State} action */
  #change(exercise, action) {
    this.#open[exercise] = action(this.#of(exercise));
    try {
      storage().set(KEY, JSON.stringify(this.#all));
      this.#open = {};
    } catch {
      // The next attempt to save a program reports the full storage; the next change tries again.
    }
  }
}

/** @param {State} state @returns {State} */
function worked(state) {
  const now = Date.now();
  const gap = now - state.seenAt;
  const isWork = !state.passed && gap >= 0 && gap <= PAUSE_MILLISECONDS;
  return { ...state, milliseconds: state.milliseconds + (isWork ? gap : 0), seenAt: now };
}

/** @param {string} exercise @param {State} state @returns {string[]} cells of the teacher's table */
function row(exercise, { passed, best, tries, milliseconds, hints, solution = false, seenAt }) {
  return [
    '',
    exercise,
    yes(passed),
    best.toFixed(1),
    String(tries),
    String(minutes(milliseconds)),
    String(hints),
    yes(solution),
    seenAt > 0 ? new Date(seenAt).toISOString() : '',
  ];
}

/** @param {boolean} is */
const yes = (is) => (is ? 'yes' : 'no');

/** @param {number} milliseconds */
const minutes = (milliseconds) => Math.round(milliseconds / 60_000);

/** @param {number} milliseconds */
function time(milliseconds) {
  const all = minutes(milliseconds);
  const hours = Math.floor(all / MINUTES_PER_HOUR);
  return hours === 0 ? `${all} min` : `${hours} h ${all % MINUTES_PER_HOUR} min`;
}
