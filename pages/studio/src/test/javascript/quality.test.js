import assert from 'node:assert/strict';
import test from 'node:test';
import {
  QUALITIES,
  QualityChooser,
  qualityIndex,
  qualityRange,
} from '../../main/resources/org/robonewbie/studio/web/state/quality.js';

/** @param {QualityChooser} chooser @param {number} milliseconds @param {number} pictures */
function draw(chooser, milliseconds, pictures) {
  let changes = 0;
  for (let i = 0; i < pictures; i++) {
    changes += chooser.pictureTook(milliseconds) ? 1 : 0;
  }
  return changes;
}

const fromHigh = () => new QualityChooser({ first: qualityIndex('high'), highest: qualityIndex('high') }, false);

test('software rendering starts low and ends below the best, a graphics card starts high', () => {
  const software = qualityRange('ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device))');

  assert.equal(QUALITIES[software.first].name, 'low');
  assert.equal(QUALITIES[software.highest].name, 'medium');
  assert.equal(QUALITIES[qualityRange('Mesa llvmpipe').first].name, 'low');
  assert.equal(QUALITIES[qualityRange('NVIDIA GeForce RTX 3060').first].name, 'high');
});

test('a fast graphics card gets shadows after two seconds, a slow one does not', () => {
  const card = qualityRange('NVIDIA GeForce RTX 3060');
  const fast = new QualityChooser(card, false);
  const slow = new QualityChooser(card, false);

  draw(fast, 16.7, 120);
  draw(slow, 30, 120);

  assert.deepEqual([fast.quality.shadows, slow.quality.shadows], [true, false]);
});

test('slow pictures lower the quality step by step down to the lowest', () => {
  const chooser = fromHigh();

  assert.equal(draw(chooser, 90, 1000), 3);
  assert.equal(chooser.quality.name, 'lowest');
});

test('one slow picture among quick ones changes nothing', () => {
  const chooser = fromHigh();
  for (let i = 0; i < 100; i++) {
    chooser.pictureTook(i % 24 === 0 ? 900 : 16);
  }

  assert.equal(chooser.quality.name, 'high');
});

test('quick pictures raise the quality up to its limit', () => {
  const chooser = new QualityChooser({ first: 0, highest: 2 }, false);

  assert.equal(draw(chooser, 16, 1000), 2);
  assert.equal(chooser.quality.name, 'medium');
});

test('a quality that was too slow is retried only after many fast rounds', () => {
  const chooser = fromHigh();
  draw(chooser, 90, 24);
  assert.equal(chooser.quality.name, 'medium');

  draw(chooser, 10, 24 * 50);
  assert.equal(chooser.quality.name, 'medium');

  draw(chooser, 10, 24 * 20);
  assert.equal(chooser.quality.name, 'high');
});

test('a quality chosen by the user is fixed', () => {
  const chooser = new QualityChooser({ first: 3, highest: 3 }, true);

  assert.equal(draw(chooser, 500, 500), 0);
});
