import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { readFrame } from '../../main/resources/org/robonewbie/studio/web/live/state-frame.js';
import { isNear } from './sample-world.js';
import { computeLinkPoses } from '../../main/resources/org/robonewbie/studio/web/state/kinematics.js';

const folder = process.env.STUDIO_FRAME_FOLDER;

/** @returns {any} output of the Java side: a scene, its frame and the expected state */
function written() {
  const bytes = readFileSync(`${folder}/frame.bin`);
  return {
    scene: JSON.parse(readFileSync(`${folder}/scene.json`, 'utf8')),
    bytes: bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length),
    truth: JSON.parse(readFileSync(`${folder}/truth.json`, 'utf8')),
  };
}

test('limbs computed from a frame equal those of the simulator', { skip: !folder && 'run by Maven' }, () => {
  const { scene, bytes, truth } = written();

  const frame = readFrame(bytes, scene);

  assert.equal(frame?.robots.length, truth.linkPoses.length);
  frame?.robots.forEach((robot, i) => {
    const model = scene.models[scene.robots[i].type];
    const poses = new Float32Array(7 * model.links.length);
    computeLinkPoses(model, robot.torso, robot.degrees, poses);
    model.links.forEach((/** @type {{name: string}} */ link, /** @type {number} */ j) => {
      const at = 7 * j;
      const off = Math.hypot(...[0, 1, 2].map((k) => poses[at + k] - truth.linkPoses[i][at + k]));
      assert.ok(off < 0.003, `${link.name} of robot ${i} is off by ${off} m`);
      const dot = [3, 4, 5, 6].reduce((sum, k) => sum + poses[at + k] * truth.linkPoses[i][at + k], 0);
      assert.ok(Math.abs(dot) > 0.9998, `${link.name} of robot ${i} is turned`);
    });
  });
});

test('time, score and play mode arrive', { skip: !folder && 'run by Maven' }, () => {
  const { scene, bytes, truth } = written();

  const frame = readFrame(bytes, scene);

  assert.equal(frame?.cycle, truth.cycle);
  assert.ok(Math.abs((frame?.gameTime ?? 0) - truth.gameTime) < 1e-3);
  assert.equal(scene.playModes[frame?.playMode ?? -1], truth.playMode);
  assert.equal(frame?.scoreRight, truth.scoreRight);
  assert.equal(frame?.speed, Infinity);
});

test('other objects on the pitch have their size and pose', { skip: !folder && 'run by Maven' }, () => {
  const { scene, bytes, truth } = written();

  const frame = readFrame(bytes, scene);

  assert.deepEqual(
    scene.things.map((/** @type {{name: string}} */ { name }) => name),
    ['slope', 'top', 'step', 'step'],
  );
  assert.ok(Math.abs(scene.things[1].size[0] - 0.7) < 1e-9);
  frame?.things?.forEach((pose, i) => assert.ok(isNear(pose, truth.thingPoses[i], 1e-4)));
  assert.equal(frame?.things?.length, 4);
});

test('a frame of another scene is ignored', { skip: !folder && 'run by Maven' }, () => {
  const { scene, bytes } = written();

  assert.equal(readFrame(bytes, { ...scene, revision: scene.revision + 1 }), undefined);
});

test('a frame of another version asks to load the page again', () => {
  assert.throws(() => readFrame(Uint8Array.of(99, 0, 0, 0).buffer, /** @type {any} */ ({})), /Reload the page/);
});
