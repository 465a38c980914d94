import assert from 'node:assert/strict';
import test from 'node:test';
import { assignmentOf, classHash } from '../../main/resources/org/robonewbie/studio/web/state/class-link.js';

test('the link of a class names exercises and trials', () => {
  const assignment = { exercises: ['raise-arms', 'stop-at-30'], seeds: 10 };

  const hash = classHash(assignment);

  assert.equal(hash, '#exercises?class=raise-arms,stop-at-30&seeds=10');
  assert.deepEqual(assignmentOf(hash), assignment);
});

test('a changed link is read as far as it makes sense', () => {
  assert.equal(assignmentOf('#field/exercises'), undefined);
  assert.equal(assignmentOf('#program?shared=abc'), undefined);
  assert.deepEqual(assignmentOf('#exercises?class=kick,kick,%3Cb%3E,../x,&seeds=900'), {
    exercises: ['kick'],
    seeds: 3,
  });
  assert.deepEqual(assignmentOf('#exercises?class='), { exercises: [], seeds: 3 });
});
