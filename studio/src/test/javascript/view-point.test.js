import assert from 'node:assert/strict';
import test from 'node:test';
import {
  eye,
  moved,
  overview,
  turned,
  zoomed,
} from '../../main/resources/org/robonewbie/studio/web/state/view-point.js';
import { isNear } from './sample-world.js';

const view = { target: [1, 2, 0], azimuthDegrees: -90, elevationDegrees: 30, distance: 10 };

test('the eye is at its distance from the target', () => {
  const [x, y, z] = eye(view);

  assert.ok(isNear([x, y, z], [1, 2 - 10 * Math.cos(Math.PI / 6), 5]));
});

test('the view neither goes underground nor over the top', () => {
  assert.equal(turned(view, 0, -500).elevationDegrees, 2);
  assert.ok(turned(view, 0, 500).elevationDegrees < 90);
});

test('zooming ends before the robot and before the horizon', () => {
  assert.ok(zoomed(view, 0.0001).distance > 0.2);
  assert.ok(zoomed(view, 10000).distance <= 60);
});

test('moving right and up follows the screen', () => {
  assert.ok(isNear(moved(view, 0.1, 0).target, [2, 2, 0]));
  assert.ok(isNear(moved(view, 0, 0.1).target, [1, 3, 0]));
});

test('the overview from the top looks straight down at the middle', () => {
  const top = overview({ length: 12, width: 8 }, 16 / 9, true);

  assert.ok(isNear(eye(top).slice(0, 2), [0, 0], 0.05));
});
