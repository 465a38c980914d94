import assert from 'node:assert/strict';
import test from 'node:test';
import {
  firstQuality,
  QUALITIES,
  QualityChooser,
  qualityIndex,
} from '../../main/resources/org/robonewbie/studio/web/state/quality.js';

/** @param {QualityChooser} chooser @param {number} milliseconds @param {number} pictures */
function draw(chooser, milliseconds, pictures) {
  let changes = 0;
  for (let i = 0; i < pictures; i++) {
    changes += chooser.pictureTook(milliseconds) ? 1 : 0;
  }
  return changes;
}

test('software rendering starts low, a graphics card high', () => {
  assert.equal(QUALITIES[firstQuality('ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device))')].name, 'low');
  assert.equal(QUALITIES[firstQuality('Mesa llvmpipe')].name, 'low');
  assert.equal(QUALITIES[firstQuality('NVIDIA GeForce RTX 3060')].name, 'high');
});

test('slow pictures lower the quality step by step down to the lowest', () => {
  const chooser = new QualityChooser(qualityIndex('high'), false);

  assert.equal(draw(chooser, 90, 1000), 3);
  assert.equal(chooser.quality.name, 'lowest');
});

test('one slow picture among quick ones changes nothing', () => {
  const chooser = new QualityChooser(qualityIndex('high'), false);
  for (let i = 0; i < 100; i++) {
    chooser.pictureTook(i % 24 === 0 ? 900 : 16);
  }

  assert.equal(chooser.quality.name, 'high');
});

test('a quality that was too slow is not tried again', () => {
  const chooser = new QualityChooser(qualityIndex('high'), false);
  draw(chooser, 90, 24);
  assert.equal(chooser.quality.name, 'medium');

  draw(chooser, 10, 2000);

  assert.equal(chooser.quality.name, 'medium');
});

test('a quality that the person has chosen stays', () => {
  const chooser = new QualityChooser(qualityIndex('high'), true);

  assert.equal(draw(chooser, 500, 500), 0);
});
