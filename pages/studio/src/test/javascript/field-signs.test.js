import assert from 'node:assert/strict';
import test from 'node:test';
import { BallPath } from '../../main/resources/org/robonewbie/studio/web/state/ball-path.js';
import {
  FASTEST_THROW,
  headingTo,
  isOnRing,
  ringRadius,
  throwOf,
} from '../../main/resources/org/robonewbie/studio/web/state/grip.js';
import { nameOf, shownTags } from '../../main/resources/org/robonewbie/studio/web/state/name-tags.js';

const tag = { x: 100, y: 100, width: 60, height: 18, metres: 5, robotPixels: 80 };

test('a long team name is truncated, and a robot without a number is called new', () => {
  assert.equal(nameOf({ team: 'Blue Newbies', number: 7 }), 'Blue Newbies 7');
  assert.equal(nameOf({ team: 'A team with a long name', number: 11 }), 'A team with a… 11');
  assert.equal(nameOf({ team: '', number: 0 }), 'new robot');
});

test('of two overlapping name tags the nearer one is shown', () => {
  const behind = { ...tag, x: 130, metres: 9 };
  const beside = { ...tag, x: 300 };

  assert.deepEqual(shownTags([behind, tag, beside]), [false, true, true]);
});

test('a robot smaller than its name tag has none', () => {
  assert.deepEqual(shownTags([{ ...tag, robotPixels: 15 }]), [false]);
});

test('the trail covers the last three seconds', () => {
  const path = new BallPath();
  for (let cycle = 0; cycle <= 500; cycle += 2) {
    path.add(cycle, [0.02 * cycle, 0, 0.04]);
  }

  const trail = path.trail;
  assert.ok(Math.abs(trail[0].place[0] - 7) < 0.1);
  assert.ok(trail[0].freshness < 0.03 && trail[trail.length - 1].freshness > 0.98);
});

test('a ball at rest has no trail, and a repositioned one starts a new trail', () => {
  const path = new BallPath();
  [0, 2, 4].forEach((cycle) => path.add(cycle, [1, 1, 0.04]));
  assert.deepEqual(path.trail, []);

  path.add(6, [1.1, 1, 0.04]);
  path.add(8, [5, 1, 0.04]);

  assert.deepEqual(path.trail, []);
});

test('going back in time starts a new trail', () => {
  const path = new BallPath();
  [10, 12, 14].forEach((cycle) => path.add(cycle, [0.1 * cycle, 0, 0.04]));

  path.add(4, [0.4, 0, 0.04]);

  assert.deepEqual(path.trail, []);
});

test('the ring is wide enough for the pointer at any distance', () => {
  assert.equal(ringRadius('ball', 0.001), 0.17);
  assert.equal(ringRadius('robot', 0.02), 0.68);
  assert.ok(isOnRing([1, 1, 0.4], [1.36, 1], 0.36));
  assert.ok(!isOnRing([1, 1, 0.4], [1.1, 1], 0.36));
});

test('a robot turns to the pointer, but does not spin when the pointer is on it', () => {
  assert.equal(headingTo([1, 1], [1, 3]), 90);
  assert.equal(headingTo([1, 1], [1.01, 1]), undefined);
});

test('the ball flies to the pointer, faster for a longer drag, up to the hardest kick', () => {
  assert.deepEqual(throwOf([0, 0], [0, 2], false), { velocity: [0, 5, 0], speed: 5 });
  assert.equal(throwOf([0, 0], [30, 0], false)?.speed, FASTEST_THROW);
  assert.equal(throwOf([0, 0], [0.01, 0], false), undefined);
  assert.ok((throwOf([0, 0], [2, 0], true)?.velocity[2] ?? 0) > 2);
});
