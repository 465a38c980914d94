import assert from 'node:assert/strict';
import test from 'node:test';
import {
  computeLinkPoses,
  headingDegrees,
  standingHeight,
} from '../../main/resources/org/robonewbie/studio/web/state/kinematics.js';
import { limbFit } from '../../main/resources/org/robonewbie/studio/web/state/limb-fit.js';
import { isNear, sampleModel } from './sample-world.js';

const HALF = Math.SQRT1_2;

/** @param {number[]} torso @param {number} degrees */
function armPose(torso, degrees) {
  const poses = new Float32Array(14);
  computeLinkPoses(sampleModel(), torso, [degrees], poses);
  return Array.from(poses.slice(7));
}

test('without rotation a link is at its position in the model', () => {
  assert.ok(isNear(armPose([1, 2, 3, 1, 0, 0, 0], 0), [1.1, 2.1, 3, 1, 0, 0, 0]));
});

test('a hinge turns by the right-hand rule about its anchor', () => {
  assert.ok(isNear(armPose([0, 0, 0, 1, 0, 0, 0], 90), [0.1, 0, 0.1, HALF, HALF, 0, 0]));
});

test('limbs follow the torso', () => {
  assert.ok(isNear(armPose([0, 0, 1, HALF, 0, 0, HALF], 0), [-0.1, 0.1, 1, HALF, 0, 0, HALF]));
});

test('heading is 0 along x and grows counter-clockwise', () => {
  assert.ok(Math.abs(headingDegrees([0, 0, 0, HALF, 0, 0, -HALF])) < 1e-4);
  assert.ok(Math.abs(headingDegrees([0, 0, 0, 1, 0, 0, 0]) - 90) < 1e-4);
});

test('standing height reaches down to the lowest corner', () => {
  assert.ok(Math.abs(standingHeight(sampleModel(), [0]) - 0.1) < 1e-6);
  assert.ok(Math.abs(standingHeight(sampleModel(), [-90]) - 0.2) < 1e-6);
});

test('a longer thigh is stretched from hip to knee', () => {
  const model = {
    links: [
      { name: 'rhip2', position: [0, 0, 0], size: [0, 0, 0] },
      { name: 'rthigh', position: [0, 0, -0.06], size: [0, 0, 0] },
      { name: 'rshank', position: [0, 0, -0.2], size: [0, 0, 0] },
    ],
    hinges: [
      { joint: '', child: 1, parent: 0, anchor: [0, 0, 0], axis: [1, 0, 0], minDegrees: 0, maxDegrees: 0 },
      { joint: '', child: 2, parent: 1, anchor: [0, 0, -0.14], axis: [1, 0, 0], minDegrees: 0, maxDegrees: 0 },
    ],
  };

  const { scale, offset } = limbFit(model, 1);

  assert.ok(Math.abs(scale[2] * 0.04 + offset[2] - 0.06) < 1e-9);
  assert.ok(Math.abs(scale[2] * -0.08 + offset[2] + 0.08) < 1e-9);
  assert.deepEqual(scale.slice(0, 2), [1, 1]);
});
