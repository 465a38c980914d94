import assert from 'node:assert/strict';
import test from 'node:test';
import {
  eye,
  fitted,
  moved,
  overview,
  robotCentre,
  robotView,
  turned,
  zoomed,
  zoomedTo,
} from '../../main/resources/org/robonewbie/studio/web/state/view-point.js';
import { isNear } from './sample-world.js';

const view = { target: [1, 2, 0], azimuthDegrees: -90, elevationDegrees: 30, distance: 10 };

const FREE = { across: 0.5, up: 0.3 };

test('the camera is at its distance from the target', () => {
  const [x, y, z] = eye(view);

  assert.ok(isNear([x, y, z], [1, 2 - 10 * Math.cos(Math.PI / 6), 5]));
});

test('the view neither goes underground nor over the top', () => {
  assert.equal(turned(view, 0, -500).elevationDegrees, 2);
  assert.ok(turned(view, 0, 500).elevationDegrees < 90);
});

test('zooming ends before the robot and before the horizon', () => {
  assert.ok(zoomed(view, 0.0001).distance > 0.2);
  assert.ok(zoomed(view, 10000).distance <= 90);
});

test('moving right and up follows the screen', () => {
  assert.ok(isNear(moved(view, 0.1, 0).target, [2, 2, 0]));
  assert.ok(isNear(moved(view, 0, 0.1).target, [1, 3, 0]));
});

test('the overview from the top looks straight down at the middle', () => {
  const top = overview({ length: 12, width: 8 }, FREE, true);

  assert.ok(isNear(eye(top).slice(0, 2), [0, 0], 0.05));
});

test('a fitted view contains all points and is as near as possible', () => {
  const fit = fitted(
    { ...view, target: [0, 0, 0], elevationDegrees: 0 },
    [
      [3, 0, 0],
      [0, 0, 1],
    ],
    FREE,
  );

  assert.equal(fit.distance.toFixed(3), '6.000');
});

test('zooming to a point keeps its direction from the camera', () => {
  const point = [4, 5, 0];
  const direction = (
    /** @type {import('../../main/resources/org/robonewbie/studio/web/state/view-point.js').ViewPoint} */ from,
  ) => {
    const way = eye(from).map((value, i) => point[i] - value);
    return way.map((value) => value / Math.hypot(...way));
  };

  const near = zoomedTo(view, 0.5, point);

  assert.equal(near.distance, 5);
  assert.ok(isNear(direction(near), direction(view)));
});

test('a robot is seen from its front right', () => {
  for (const heading of [-120, 0, 90, 180]) {
    const [x, y] = [-5, 1];
    const [ex, ey, ez] = eye(robotView([x, y, 0.29], heading, FREE));
    const [sine, cosine] = [Math.sin((heading * Math.PI) / 180), Math.cos((heading * Math.PI) / 180)];
    const forward = cosine * (ex - x) + sine * (ey - y);
    const right = sine * (ex - x) - cosine * (ey - y);

    assert.ok(right > forward && forward > 0.7 * right, `in front, and to the right, for ${heading}°`);
    assert.ok(ez > 0.5, 'from slightly above');
  }
});

test('a robot fills half of the height, whatever the shape of the picture', () => {
  for (const free of [FREE, { across: 0.6, up: 0.2 }, { across: 0.3, up: 0.34 }]) {
    const { distance } = robotView(robotCentre([3, -2, 0.4]), 45, free);

    const share = 0.29 / distance / free.up;

    assert.ok(share > 0.45 && share < 0.55, `${share} of ${free.up}`);
  }
});

test('a robot with its arms spread fits into a narrow picture', () => {
  const { distance } = robotView([0, 0, 0.29], 0, { across: 0.1, up: 0.3 });

  assert.ok(0.3 / distance <= 0.1001);
});
