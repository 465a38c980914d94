import assert from 'node:assert/strict';
import test from 'node:test';
import { buttonsOfPad, walkOfPad } from '../../main/resources/org/robonewbie/studio/web/state/gamepad.js';

const buttons = Array.from({ length: 16 }, () => ({ pressed: false }));

test('the left stick walks and the right one turns, in coarse steps', () => {
  assert.deepEqual(walkOfPad({ axes: [0, -1, 0, 0], buttons }), { forward: 1, left: 0, turn: 0 });
  assert.deepEqual(walkOfPad({ axes: [-0.52, 0, 0.61, 0], buttons }), { forward: 0, left: 0.6, turn: -0.6 });
});

test('an untouched stick has a dead zone', () => {
  assert.deepEqual(walkOfPad({ axes: [0.1, -0.12, 0.05, 0], buttons }), { forward: 0, left: 0, turn: 0 });
});

test('a button kicks once, however long it is held', () => {
  const held = buttons.map((_, i) => ({ pressed: i === 0 }));

  const first = buttonsOfPad({ axes: [], buttons: held }, new Set());
  const second = buttonsOfPad({ axes: [], buttons: held }, first.down);

  assert.equal(first.motion, 'kick-right');
  assert.equal(second.motion, undefined);
});
