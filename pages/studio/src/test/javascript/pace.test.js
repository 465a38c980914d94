import assert from 'node:assert/strict';
import test from 'node:test';
import { paced } from '../../main/resources/org/robonewbie/studio/web/panels/pace.js';

test('frequent requests are throttled, and the last one is drawn', () => {
  /** @type {number[]} */
  const drawn = [];
  const pace = paced((now) => drawn.push(now), 90);

  for (let now = 0; now <= 200; now += 20) {
    if (now <= 120) {
      pace.ask();
    }
    pace.turn(now);
  }

  assert.deepEqual(drawn, [0, 100, 200]);
});
