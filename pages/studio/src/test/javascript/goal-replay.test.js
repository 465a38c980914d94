import assert from 'node:assert/strict';
import test from 'node:test';
import { GoalReplay, lineUpChanges } from '../../main/resources/org/robonewbie/studio/web/state/goal-replay.js';

test('a goal is replayed from five seconds before it at half speed, then the present is shown', () => {
  const replay = new GoalReplay();
  replay.scored(1000);

  assert.equal(replay.turn(0.1, { first: 0, last: 1000 }), 'nothing');
  assert.equal(replay.turn(0.1, { first: 0, last: 1070 }), 'shows');
  assert.equal(replay.at, 750);
  assert.equal(replay.turn(2, { first: 0, last: 1200 }), 'shows');
  assert.equal(replay.at, 800);
  assert.equal(replay.turn(20, { first: 0, last: 2000 }), 'ends');
  assert.equal(replay.turn(1, { first: 0, last: 2000 }), 'nothing');
});

test('a goal shortly after the page was opened is replayed from the available frames', () => {
  const replay = new GoalReplay();
  replay.scored(1000);

  replay.turn(0.1, { first: 980, last: 1100 });

  assert.equal(replay.at, 980);
});

test('joining and leaving robots are announced', () => {
  const blue = (number) => ({ team: 'Blue', number });

  assert.deepEqual(lineUpChanges([blue(1), blue(2)], [blue(2), blue(12), blue(0)]), ['Blue 1 leaves', 'Blue 12 joins']);
});
