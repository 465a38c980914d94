import assert from 'node:assert/strict';
import test from 'node:test';
import { blendPose, Smoothing } from '../../main/resources/org/robonewbie/studio/web/state/smoothing.js';
import { isNear, sampleFrame } from './sample-world.js';

/** @param {number} x @param {number} degrees @param {object} [changes] */
const frameAt = (x, degrees, changes) =>
  sampleFrame({
    robots: [{ torso: Float32Array.of(x, 0, 0.4, 1, 0, 0, 0), degrees: Float32Array.of(degrees) }],
    ...changes,
  });

/** @param {Smoothing} smoothing */
function settledAt40(smoothing) {
  for (let i = 0; i < 60; i++) {
    smoothing.push(frameAt(0, 0), 40 * i);
  }
}

test('the first frame is drawn without interpolation', () => {
  const smoothing = new Smoothing();
  const frame = frameAt(1, 10);
  smoothing.push(frame, 0);

  assert.equal(smoothing.picture(5), frame);
  assert.equal(smoothing.isMoving(5), false);
});

test('half an interval later the picture is halfway', () => {
  const smoothing = new Smoothing();
  settledAt40(smoothing);
  smoothing.push(frameAt(0.1, 20), 2400);

  const robot = smoothing.picture(2420)?.robots[0];

  assert.ok(Math.abs((robot?.torso[0] ?? 0) - 0.05) < 0.01);
  assert.ok(Math.abs((robot?.degrees[0] ?? 0) - 10) < 2);
  assert.equal(smoothing.isMoving(2420), true);
});

test('after an interval the frame is reached and the picture is still', () => {
  const smoothing = new Smoothing();
  settledAt40(smoothing);
  const last = frameAt(0.1, 20);
  smoothing.push(last, 2400);

  assert.equal(smoothing.picture(2460), last);
  assert.equal(smoothing.isMoving(2480), false);
});

test('a repositioned robot is not interpolated', () => {
  const smoothing = new Smoothing();
  settledAt40(smoothing);
  smoothing.push(frameAt(3, 0), 2400);

  assert.equal(smoothing.picture(2401)?.robots[0].torso[0], 3);
});

test('frames of another scene are not blended', () => {
  const smoothing = new Smoothing();
  settledAt40(smoothing);
  const other = frameAt(0.1, 20, { sceneRevision: 4 });
  smoothing.push(other, 2400);

  assert.equal(smoothing.picture(2401), other);
});

test('rotations blend along the shorter way', () => {
  const blended = blendPose(Float32Array.of(0, 0, 0, 1, 0, 0, 0), Float32Array.of(0, 0, 0, -1, 0, 0, 0), 0.5);

  assert.ok(isNear(Array.from(blended).map(Math.abs), [0, 0, 0, 1, 0, 0, 0]));
});
