import assert from 'node:assert/strict';
import test from 'node:test';
import { numberOf, roundStep } from '../../main/resources/org/robonewbie/studio/web/state/numbers.js';

test('a number may have a decimal comma, and other texts are refused', () => {
  assert.equal(numberOf(' 12,5 '), 12.5);
  assert.equal(numberOf('-3'), -3);
  for (const text of ['', ' ', '12,5,1', 'abc', 'Infinity', 'NaN']) {
    assert.equal(numberOf(text), undefined, text);
  }
});

test('ticks of a scale are few and have round distances at every range', () => {
  assert.equal(roundStep(56), 100);
  assert.equal(roundStep(1), 1);
  assert.equal(roundStep(0.3), 0.5);
  for (let span = 1e-3; span < 1e15; span *= 3.7) {
    const lines = span / roundStep(span / 6);
    assert.ok(lines > 2 && lines <= 6, String(span));
  }
});
