import assert from 'node:assert/strict';
import test from 'node:test';
import {
  assignmentOf,
  classHash,
  isClassLink,
} from '../../main/resources/org/robonewbie/studio/web/state/class-link.js';

test('the link of a class names exercises and trials', () => {
  const assignment = { exercises: ['raise-arms', 'stop-at-30'], seeds: 10 };

  const hash = classHash(assignment);

  assert.equal(hash, '#exercises?class=raise-arms,stop-at-30&seeds=10');
  assert.deepEqual(assignmentOf(hash), assignment);
});

test('a link whose commas a mail program has encoded is read, and a name that occurs twice counts once', () => {
  assert.deepEqual(assignmentOf('#exercises?class=kick%2Cdance%2ckick&seeds=3'), {
    exercises: ['kick', 'dance'],
    seeds: 3,
  });
});

test('a link that is not whole is refused', () => {
  for (const rest of ['', 'kick', 'kick&seeds=', 'kick&seeds=0', 'kick&seeds=21', 'kick&seeds=3x', 'kick,&seeds=3']) {
    assert.throws(() => assignmentOf(`#exercises?class=${rest}`), /incomplete or damaged/);
  }
  assert.throws(() => assignmentOf('#exercises?class=%3Cb%3E,../x&seeds=3'), /incomplete or damaged/);
});

test('other addresses are no links of a class', () => {
  assert.equal(isClassLink('#field/exercises'), false);
  assert.equal(isClassLink('#program?shared=abc'), false);
  assert.equal(isClassLink('#exercises?class='), true);
});
