import assert from 'node:assert/strict';
import test from 'node:test';
import { hidesRobot } from '../../main/resources/org/robonewbie/studio/web/state/goal-occlusion.js';
import { robotCentre, robotView } from '../../main/resources/org/robonewbie/studio/web/state/view-point.js';

const FIELD = /** @type {any} */ ({ length: 12, goalWidth: 2.1, goalDepth: 0.6, goalHeight: 0.8 });
const FREE = { across: 0.5, up: 0.26 };
const [LEFT, RIGHT] = [-1, 1];

/** @param {number} x @param {number} y @param {number} azimuthDegrees */
const seenFrom = (x, y, azimuthDegrees) => ({
  ...robotView(robotCentre([x, y, 0.4]), 0, FREE),
  azimuthDegrees,
});

test('a goal hides the robot that is seen from behind the goal', () => {
  assert.ok(hidesRobot(FIELD, LEFT, seenFrom(-5, 0, 180)));
  assert.ok(hidesRobot(FIELD, RIGHT, seenFrom(5, 0.5, 10)));
});

test('a goal hides the robot although the camera stands within it', () => {
  const view = { ...seenFrom(-5, 0, 180), distance: 1.3 };

  assert.ok(hidesRobot(FIELD, LEFT, view));
});

test('a goal behind the robot or beside the line of sight hides nothing', () => {
  assert.ok(!hidesRobot(FIELD, LEFT, seenFrom(-5, 0, -50)));
  assert.ok(!hidesRobot(FIELD, RIGHT, seenFrom(-5, 0, 180)));
  assert.ok(!hidesRobot(FIELD, LEFT, seenFrom(-5, 3, 180)));
});

test('a goalkeeper is seen through the open mouth of its goal', () => {
  assert.ok(!hidesRobot(FIELD, LEFT, seenFrom(-5.9, 0, -50)));
  assert.ok(!hidesRobot(FIELD, LEFT, seenFrom(-6.15, 0, 0)));
});

test('a single post hides the robot', () => {
  assert.ok(hidesRobot(FIELD, LEFT, seenFrom(-6.3, 0.5, 55)));
  assert.ok(hidesRobot(FIELD, LEFT, seenFrom(-6, -1.6, 90)));
});

test('a robot seen from high above the crossbar is not hidden', () => {
  assert.ok(!hidesRobot(FIELD, LEFT, { ...seenFrom(-5, 0, 180), elevationDegrees: 60 }));
});
