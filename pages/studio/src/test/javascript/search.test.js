import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  bars,
  duration,
  facts,
  initialSearch,
  sentence,
  stepCurve,
  valueCurves,
  withNews,
  withoutLine,
} from '../../main/resources/org/robonewbie/studio/web/state/search.js';

const TASK = {
  subject: 'kick-right',
  objective: 'kick-distance',
  unit: 'm',
  isLargerBetter: true,
  rounds: 4,
  method: 'CMA-ES',
};
const round = (number) => ({
  number,
  best: 5 + number,
  mean: 4 + number,
  success: 0.75,
  step: 1 / number,
  trialsPerSecond: 12,
  secondsLeft: 75,
});
const number = (value, spread = 1) => ({ name: 'knee', unit: 'degrees', start: 10, value, spread, size: 5 });

const whole = {
  kind: 'whole',
  task: TASK,
  rounds: [round(1)],
  numbers: [number(11)],
  before: 5.5,
  place: '#motion/kick',
};

test('a page that connects late gets the earlier rounds', () => {
  const late = withNews(initialSearch(), whole);
  const later = withNews(late, { kind: 'round', round: round(2), numbers: [number(12)], place: '#motion/kick' });

  assert.equal(late.phase, 'running');
  assert.deepEqual(valueCurves(later), [
    [1, 2],
    [6, 7],
    [5, 6],
    [5.5, 5.5],
  ]);
  assert.deepEqual(stepCurve(later), [
    [1, 2],
    [1, 0.5],
  ]);
  assert.equal(later.numbers[0].value, 12);
});

test('facts have their units', () => {
  const values = Object.fromEntries(facts(withNews(initialSearch(), whole)));

  assert.equal(values['Round'], '1 of 4');
  assert.equal(values['Start'], '5.500 m');
  assert.equal(values['Successful trials'], '75 %');
  assert.equal(values['Time left'], '1:15');
});

test('the results of a search outlive its program', () => {
  const ended = withoutLine(withNews(initialSearch(), { ...whole, after: 6.1, outcome: 'Written to kick.txt.' }));
  const broken = withoutLine(withNews(initialSearch(), whole));

  assert.deepEqual(sentence(ended), { tone: 'done', text: 'Written to kick.txt.' });
  assert.equal(ended.rounds.length, 1);
  assert.equal(ended.place, '');
  assert.match(sentence(broken).text, /--resume/);
});

test('the numbers that changed most come first', () => {
  const shown = bars([number(11), number(0), number(15)], 2);

  assert.deepEqual(
    shown.map(({ value }) => value),
    [0, 15],
  );
  assert.ok(shown[0].at < 0.5 && shown[1].at > 0.5);
  assert.ok(shown.every(({ at, half }) => at - half >= 0 && at + half <= 1));
});

test('durations are formatted like clock times', () => {
  assert.equal(duration(9), '0:09');
  assert.equal(duration(3909), '1:05:09');
});
