import assert from 'node:assert/strict';
import test from 'node:test';
import { paced } from '../../main/resources/org/robonewbie/studio/web/panels/pace.js';

test('what is asked for often is drawn at its pace, and the last wish is not forgotten', () => {
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
