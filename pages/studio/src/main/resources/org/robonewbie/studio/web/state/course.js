/** Describes exercises and their trials to the user. Pure. */

/**
 * @typedef {{tries: number, best: number, passed: boolean, minutes: number}} Standing
 * @typedef {{hints: string[], allHints: number, solution: boolean, triesLeft: number}} Help
 * @typedef {{sum: string, badges: string[], csv: string}} Standings
 * @typedef {{number: number, name: string, title: string, goal: string, level: string, minutes: number, points: number, worksheet: string, file: string, standing: Standing}} Lesson
 * @typedef {{seed: number, passed: boolean, points: number, finding: string, hint: string}} Judged
 * @typedef {{id: number, state: 'NONE' | 'WAITING' | 'RUNNING' | 'OVER', exercise: string, program: string, port: number, trials: number, judged: Judged[], points: number, passed: boolean, output: string}} Attempt
 */

/** @param {readonly Lesson[]} lessons in the order of the course @returns {Lesson[]} sorted by level */
export function byLevel(lessons) {
  const levels = lessons.map(({ level }) => level);
  return [...lessons].sort((one, other) => levels.indexOf(one.level) - levels.indexOf(other.level));
}

/** @param {Lesson} lesson @returns {string} its level, and the progress so far */
export function lessonLine({ level, minutes, points, standing }) {
  if (standing.tries === 0) {
    return `${level} · ${minutes} min`;
  }
  const tries = standing.tries === 1 ? '1 try' : `${standing.tries} tries`;
  return `${level} · ${standing.best.toFixed(1)} of ${points} points · ${tries} · ${standing.minutes} min`;
}

/** @param {Lesson} lesson */
export function lessonTitle({ number, title, standing }) {
  return `${standing.passed ? '✓ ' : ''}${number} ${title}`;
}

/** @param {Help} help @returns {string} label of the button for the next hint; empty if all hints are shown */
export function hintButton({ hints: open, allHints }) {
  return open.length < allHints ? `Open hint ${open.length + 1} of ${allHints}` : '';
}

/** @param {Help} help @returns {string} label of the solution button */
export function solutionButton({ triesLeft }) {
  if (triesLeft === 0) {
    return 'Show me a solution';
  }
  return `Solution after ${triesLeft === 1 ? 'one more try' : `${triesLeft} more tries`}`;
}

/** @param {Attempt} attempt @returns {string} the current state, as a sentence */
export function progressText(attempt) {
  const trial = `Trial ${attempt.judged.length + 1} of ${attempt.trials}`;
  if (attempt.state === 'WAITING') {
    return attempt.program
      ? `${trial}: ${attempt.program} is starting…`
      : `${trial} is waiting for your agent. Start it with: ./robonewbie run MyAgent.java --port ${attempt.port} --team Students`;
  }
  if (attempt.state === 'RUNNING') {
    return `${trial} is running and being graded.`;
  }
  if (attempt.state === 'NONE' || attempt.judged.length < attempt.trials) {
    return '';
  }
  return `${attempt.passed ? 'Passed' : 'Not yet passed'}: ${attempt.points.toFixed(1)} of 10 points`;
}

/** @param {Attempt} attempt @returns {string} the trial whose program is starting; empty if there is none */
export function startingText({ state, program, judged }) {
  return state === 'WAITING' && program ? `Starting trial ${judged.length + 1}…` : '';
}

/** @param {Attempt} attempt @returns {string} whether its program has passed, as a sentence; empty without an attempt */
export function checkText({ state, program, passed }) {
  const name = program?.replace(/^.*\//, '').replace(/\.java$/, '');
  if (state === 'NONE' || !name) {
    return '';
  }
  return state === 'OVER' ? `${name} has ${passed ? '' : 'not '}passed.` : `${name} is being checked…`;
}

/** @param {Judged} trial */
export function trialText({ seed, passed, points, finding }) {
  return `${passed ? '✓' : '✗'} Seed ${seed}: ${points} points, ${finding}`;
}

/** @param {Attempt} attempt @returns {string[]} each hint once */
export function hints({ judged }) {
  return [...new Set(judged.map(({ hint }) => hint).filter((hint) => hint !== ''))];
}

/**
 * Chooses the program that is most likely to solve an exercise.
 *
 * @param {Lesson} lesson
 * @param {string[]} programs
 * @returns {string} the program; empty if none is likely
 */
export function likelyProgram(lesson, programs) {
  return programs.includes(lesson.file) ? lesson.file : '';
}
