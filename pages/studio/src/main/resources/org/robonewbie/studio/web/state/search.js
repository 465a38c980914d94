/** State of a search for better values of an agent's parameters. */
import { phaseSentence, phaseWithoutLine } from './reports.js';

/**
 * @typedef {object} Task
 * @property {string} subject
 * @property {string} objective
 * @property {string} unit
 * @property {boolean} isLargerBetter
 * @property {number} rounds
 * @property {string} method
 */
/** @typedef {{number: number, best: number, mean: number, success: number, step: number, trialsPerSecond: number, secondsLeft: number}} Round */
/** @typedef {{name: string, unit: string, start: number, value: number, spread: number, size: number}} SearchedNumber */

/**
 * @typedef {object} Search
 * @property {import('./reports.js').Phase} phase
 * @property {string} refusal why the connection was rejected
 * @property {Task | undefined} task
 * @property {readonly Round[]} rounds
 * @property {readonly SearchedNumber[]} numbers
 * @property {number | undefined} before objective value with the initial numbers
 * @property {number | undefined} after objective value with the numbers found
 * @property {string} outcome
 * @property {string} place end of the address of the live view of the current state
 */

/** @returns {Search} */
export function initialSearch() {
  return {
    phase: 'waiting',
    refusal: '',
    task: undefined,
    rounds: [],
    numbers: [],
    before: undefined,
    after: undefined,
    outcome: '',
    place: '',
  };
}

/**
 * @param {Search} search
 * @param {any} news a message from the live feed
 * @returns {Search}
 */
export function withNews(search, news) {
  if (news.kind === 'whole') {
    const { task, rounds, numbers = [], before, after, outcome = '', place = '' } = news;
    return { ...search, phase: outcome ? 'ended' : 'running', task, rounds, numbers, before, after, outcome, place };
  }
  return { ...search, rounds: [...search.rounds, news.round], numbers: news.numbers, place: news.place };
}

/** Keeps the results after the connection was lost, but removes the link to the live view. @param {Search} search @returns {Search} */
export function withoutLine(search) {
  return { ...search, place: '', phase: phaseWithoutLine(search.phase) };
}

/** Returns the columns of the objective plot: round, best, mean, start. @param {Search} search */
export function valueCurves({ rounds, before }) {
  return [
    rounds.map((round) => round.number),
    rounds.map((round) => round.best),
    rounds.map((round) => round.mean),
    rounds.map(() => before ?? null),
  ];
}

/** Returns the columns of the step size plot. @param {Search} search */
export function stepCurve({ rounds }) {
  return [rounds.map((round) => round.number), rounds.map((round) => round.step)];
}

/** @param {Search} search @returns {Array<[string, string]>} labels and values */
export function facts({ task, rounds, before, after, phase }) {
  if (!task) {
    return [];
  }
  const last = rounds.at(-1);
  const value = (/** @type {number | undefined} */ number) =>
    number === undefined ? '–' : `${number.toFixed(3)} ${task.unit}`;
  return [
    ['Round', `${last?.number ?? 0} of ${task.rounds}`],
    ['Start', value(before)],
    ['Best of this round', value(last?.best)],
    ['Mean', value(last?.mean)],
    ...(after === undefined ? [] : [/** @type {[string, string]} */ (['Result', value(after)])]),
    ['Successful trials', last ? `${Math.round(100 * last.success)} %` : '–'],
    [
      'Trials per second',
      last && last.trialsPerSecond > 0 ? last.trialsPerSecond.toFixed(last.trialsPerSecond < 10 ? 1 : 0) : '–',
    ],
    ['Time left', phase === 'running' && last && last.trialsPerSecond > 0 ? duration(last.secondsLeft) : '–'],
  ];
}

/** @param {Search} search @returns {{tone: string, text: string}} */
export function sentence(search) {
  return phaseSentence(search, {
    waiting: 'Waiting for the optimisation …',
    running: search.rounds.length === 0 ? 'The first candidates are being evaluated …' : '',
    lost: 'To continue an interrupted run, run the command again with --resume.',
    ended: search.outcome,
  });
}

/** @param {number} seconds @returns {string} text such as 1:05:09 */
export function duration(seconds) {
  const whole = Math.max(0, Math.round(seconds));
  const two = (/** @type {number} */ number) => String(number).padStart(2, '0');
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60];
  return hours > 0 ? `${hours}:${two(minutes)}:${two(whole % 60)}` : `${minutes}:${two(whole % 60)}`;
}

/**
 * Returns the numbers with the largest changes, with the ends of their bars between 0 and 1.
 *
 * @param {readonly SearchedNumber[]} numbers
 * @param {number} max maximum number of entries
 */
export function bars(numbers, max) {
  const reach = Math.max(
    0.5,
    ...numbers.map(({ start, value, spread, size }) => (Math.abs(value - start) + spread) / size),
  );
  const change = (/** @type {SearchedNumber} */ { start, value, size }) => (value - start) / size;
  return [...numbers]
    .sort((a, b) => Math.abs(change(b)) - Math.abs(change(a)))
    .slice(0, max)
    .map((number) => ({
      ...number,
      at: 0.5 + change(number) / reach / 2,
      half: number.spread / number.size / reach / 2,
    }));
}
