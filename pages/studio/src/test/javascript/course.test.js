import assert from 'node:assert/strict';
import test from 'node:test';
import {
  byLevel,
  checkText,
  hints,
  progressText,
  startingText,
  trialText,
  likelyProgram,
} from '../../main/resources/org/robonewbie/studio/web/state/course.js';

/** @typedef {import('../../main/resources/org/robonewbie/studio/web/state/course.js').Attempt} Attempt */

const trial = { seed: 1, passed: false, points: 4, finding: 'the ball went 1.00 m', hint: 'Be quick.' };

/** @type {Attempt} */
const attempt = {
  id: 1,
  state: 'RUNNING',
  exercise: 'kick',
  program: 'Kick.java',
  port: 3110,
  trials: 2,
  judged: [trial],
  points: 4,
  passed: false,
  output: '',
};

test('exercises are listed by level, each level in the order of the course', () => {
  const levels = ['first steps', 'basics', 'challenge', 'first steps', 'basics'];
  const lessons = levels.map((level, i) => /** @type {any} */ ({ number: i + 1, level }));

  assert.deepEqual(
    byLevel(lessons).map(({ number }) => number),
    [1, 4, 2, 5, 3],
  );
});

test('progress names the running trial and the results of all', () => {
  assert.equal(progressText(attempt), 'Trial 2 of 2 is running and being graded.');
  assert.equal(progressText({ ...attempt, state: 'WAITING' }), 'Trial 2 of 2: Kick.java is starting…');
  assert.equal(progressText({ ...attempt, state: 'OVER', judged: [trial, trial] }), 'Not yet passed: 4.0 of 10 points');
  assert.equal(
    progressText({ ...attempt, state: 'OVER', judged: [trial, trial], passed: true, points: 10 }),
    'Passed: 10.0 of 10 points',
  );
  assert.equal(progressText({ ...attempt, state: 'NONE' }), '');
});

test('a trial starts until its program has come', () => {
  assert.equal(startingText({ ...attempt, state: 'WAITING' }), 'Starting trial 2…');
  assert.equal(startingText({ ...attempt, state: 'WAITING', program: '' }), '');
  assert.equal(startingText(attempt), '');
});

test('the state of a check names the program', () => {
  assert.equal(checkText({ ...attempt, program: 'src/main/java/Kick.java' }), 'Kick is being checked…');
  assert.equal(checkText({ ...attempt, state: 'OVER', passed: true }), 'Kick has passed.');
  assert.equal(checkText({ ...attempt, state: 'OVER', passed: false }), 'Kick has not passed.');
  assert.equal(checkText({ ...attempt, state: 'NONE' }), '');
  assert.equal(checkText({ ...attempt, program: '' }), '');
});

test('the user’s own agent gets a command to join', () => {
  assert.match(progressText({ ...attempt, state: 'WAITING', program: '' }), /MyAgent\.java --port 3110/);
});

test('a trial shows seed, points and measurement, and each hint once', () => {
  assert.equal(trialText(trial), '✗ Seed 1: 4 points, the ball went 1.00 m');
  assert.deepEqual(hints({ ...attempt, judged: [trial, { ...trial, seed: 2 }, { ...trial, hint: '' }] }), [
    'Be quick.',
  ]);
});

test('the likely program is chosen if it exists', () => {
  const lesson = {
    number: 12,
    name: 'kick',
    title: '',
    goal: '',
    level: '',
    minutes: 1,
    points: 10,
    worksheet: '',
    file: 'Kick.java',
  };

  assert.equal(likelyProgram(lesson, ['Kick.java', 'Other.java']), 'Kick.java');
  assert.equal(likelyProgram(lesson, ['Other.java']), '');
});
