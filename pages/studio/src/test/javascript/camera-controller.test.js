import assert from 'node:assert/strict';
import test from 'node:test';
import { CameraController } from '../../main/resources/org/robonewbie/studio/web/field/camera-controller.js';
import { sampleScene } from './sample-world.js';

/** @returns {any} a camera that only keeps its position */
function camera() {
  const position = { at: [0, 0, 0], set: (/** @type {number[]} */ ...at) => (position.at = at) };
  return { fov: 38, aspect: 1.6, position, up: { set() {} }, lookAt() {}, updateProjectionMatrix() {} };
}

/** @param {number} x @param {number} y @param {number} headingDegrees @returns {Float32Array} poses of a standing robot */
function robotAt(x, y, headingDegrees) {
  const half = ((headingDegrees - 90) * Math.PI) / 360;
  return Float32Array.of(x, y, 0.4, Math.cos(half), 0, 0, Math.sin(half));
}

/** @param {number} robots */
function controllerOf(robots) {
  const controller = new CameraController(camera());
  const scene = sampleScene();
  controller.setScene({ ...scene, robots: Array(robots).fill(scene.robots[0]) });
  return controller;
}

/** @param {CameraController} controller @param {Float32Array} robot @returns {number} direction of the camera from the robot */
function settled(controller, robot) {
  do {
    controller.update([robot], 0.1);
  } while (!controller.isStill);
  return controller.shown.azimuthDegrees;
}

test('the first picture of a single robot is its view from the front right, without a transition', () => {
  const controller = controllerOf(1);

  controller.update([new Float32Array(7)], 0.02);
  controller.update([robotAt(-5, 0, 0)], 0.02);

  assert.equal(controller.mode, 'follow');
  assert.ok(Math.abs(controller.shown.azimuthDegrees + 50) < 0.01);
  assert.deepEqual(controller.shown.target.slice(0, 2), [-5, 0]);
});

test('several robots are shown from the touchline', () => {
  assert.equal(controllerOf(2).mode, 'orbit');
});

test('the camera stands still while the robot turns, and comes to its front after a beam', () => {
  const controller = controllerOf(1);
  const first = settled(controller, robotAt(-5, 0, 0));

  assert.equal(settled(controller, robotAt(-4.9, 0, 120)), first);
  assert.ok(Math.abs(settled(controller, robotAt(2, 1, 120)) - first - 120) < 0.1);
});

test('the user’s direction and distance are kept after a beam', () => {
  const controller = controllerOf(1);
  settled(controller, robotAt(-5, 0, 0));
  controller.turn(20, 0);
  controller.zoom(0.5);
  const { azimuthDegrees, distance } = controller.view;

  settled(controller, robotAt(2, 1, 180));

  assert.ok(Math.abs(controller.shown.azimuthDegrees - azimuthDegrees) < 0.1);
  assert.ok(Math.abs(controller.shown.distance - distance) < 0.01);
});

test('panels that open move the camera back until the robot fits again', () => {
  let free = { across: 0.5, up: 0.3 };
  const controller = new CameraController(camera(), () => free);
  controller.setScene(sampleScene());
  settled(controller, robotAt(0, 0, 0));
  const before = controller.shown.distance;

  free = { across: 0.5, up: 0.15 };
  settled(controller, robotAt(0, 0, 0));

  assert.ok(controller.shown.distance > 1.9 * before);
});

test('a video repeats the composed view in its own picture', () => {
  const shown = controllerOf(1);
  settled(shown, robotAt(-5, 0, 0));
  const video = controllerOf(1);

  video.lookAs(shown);
  video.update([robotAt(-5, 0, 50)], 1);

  assert.ok(Math.abs(video.shown.azimuthDegrees + 50) < 0.01);
});
