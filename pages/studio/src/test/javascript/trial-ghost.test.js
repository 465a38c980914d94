import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { readFrame } from '../../main/resources/org/robonewbie/studio/web/live/state-frame.js';
import { TrialGhost } from '../../main/resources/org/robonewbie/studio/web/state/trial-ghost.js';

const folder = process.env.STUDIO_FRAME_FOLDER;

test(
  'the ghost is the last trial with the same seed, or the last one at all',
  { skip: folder ? false : 'run by Maven' },
  () => {
    const pitch = JSON.parse(readFileSync(join(String(folder), 'scene.json'), 'utf8'));
    const bytes = new Uint8Array(readFileSync(join(String(folder), 'frame.bin'))).buffer;
    const ghost = new TrialGhost();
    const scene = (/** @type {number} */ attempt, /** @type {number} */ seed, task = 'kick') => ({
      ...pitch,
      trial: { task, attempt, seed },
    });
    const play = (/** @type {any} */ where, /** @type {number[]} */ cycles) => {
      for (const cycle of cycles) {
        const copy = bytes.slice(0);
        new DataView(copy).setUint32(4, cycle, true);
        ghost.receive(cycle, where, copy);
      }
    };
    const besides = (/** @type {any} */ where, /** @type {number} */ cycle) => {
      const frame = readFrame(bytes, pitch);
      return ghost.beside(where, frame && { ...frame, cycle })?.frame.cycle;
    };

    play(pitch, [900]);
    play(scene(1, 1), [0, 10, 20]);
    assert.equal(besides(scene(1, 1), 10), undefined);
    play(scene(1, 2), [0, 12, 22]);
    assert.equal(besides(scene(1, 2), 15), 10);
    play(scene(2, 1), [0]);
    assert.equal(besides(scene(2, 1), 15), 10);
    assert.equal(besides(scene(2, 3), 15), 12);
    assert.equal(besides(scene(2, 1), 99), 20);
    assert.equal(besides(scene(2, 1, 'dance'), 15), undefined);
    assert.equal(besides(pitch, 15), undefined);
    ghost.isOn = false;
    assert.equal(besides(scene(2, 1), 15), undefined);
  },
);
