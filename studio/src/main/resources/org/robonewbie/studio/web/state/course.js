/** What the page says about an exercise and its trials. Pure. */

/**
 * @typedef {{number: number, name: string, title: string, goal: string, level: string, minutes: number, points: number, worksheet: string, file: string}} Lesson
 * @typedef {{seed: number, passed: boolean, points: number, finding: string, hint: string}} Judged
 * @typedef {{id: number, state: 'NONE' | 'WAITING' | 'RUNNING' | 'OVER', exercise: string, program: string, port: number, trials: number, judged: Judged[], points: number, passed: boolean, output: string}} Attempt
 */

/** @param {Lesson} lesson */
export function lessonLine({ level, minutes, points }) {
  return `${level} · ${minutes} min · ${points} points`;
}

/** @param {Attempt} attempt @returns {string} what happens now, as a sentence */
export function progressText(attempt) {
  const trial = `Trial ${attempt.judged.length + 1} of ${attempt.trials}`;
  if (attempt.state === 'WAITING') {
    return attempt.program
      ? `${trial}: ${attempt.program} is starting…`
      : `${trial} waits for your agent. Start it with: ./robonewbie run MyAgent.java --port ${attempt.port} --team Students`;
  }
  if (attempt.state === 'RUNNING') {
    return `${trial} is running and being judged.`;
  }
  if (attempt.state === 'NONE' || attempt.judged.length < attempt.trials) {
    return '';
  }
  return `${attempt.passed ? 'Passed' : 'Not yet passed'}: ${attempt.points.toFixed(1)} of 10 points`;
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
 * Chooses the program that most likely solves an exercise.
 *
 * @param {Lesson} lesson
 * @param {string[]} programs
 * @returns {string} empty if none of them does
 */
export function usualProgram(lesson, programs) {
  return programs.includes(lesson.file) ? lesson.file : '';
}
