import assert from 'node:assert/strict';
import test from 'node:test';
import { fixed } from '../../main/resources/org/robonewbie/studio/web/state/numbers.js';
import {
  readExpressions,
  writeExpression,
} from '../../main/resources/org/robonewbie/studio/web/state/robot/expressions.js';
import { readOrders, readSenses } from '../../main/resources/org/robonewbie/studio/web/state/robot/senses.js';

const MESSAGE =
  '(time (now 104.87))(GS (unum 1) (team left) (t 0.00) (pm BeforeKickOff))(hear 12.30 self hello)(hear Blue 12.32 -45.5 go)' +
  '(GYR (n torso) (rt 1.00 2.00 3.00))(ACC (n torso) (a 0.00 0.50 9.81))(HJ (n hj1) (ax -0.00))' +
  '(See (G2R (pol 17.55 -3.33 4.31)) (B (pol 8.51 -0.21 -0.17)) (P (team Red) (id 3) (head (pol 16.98 -0.21 3.19)) (rlowerarm (pol 16.83 -0.06 2.80)))' +
  ' (L (pol 12.11 -40.77 -2.40) (pol 12.95 -37.76 -2.41)))(FRP (n lf) (c 0.01 0.05 -0.01) (f 1.00 2.00 22.00))';

test('a message is read and written as expressions', () => {
  assert.deepEqual(readExpressions('(a (b 1) c)(d )'), [['a', ['b', '1'], 'c'], ['d']]);
  assert.deepEqual(readExpressions('(a (b'), [['a', ['b']]]);
  assert.deepEqual(readExpressions(') x'), ['x']);
  assert.equal(readExpressions(MESSAGE).map(writeExpression).join(''), MESSAGE);
});

test('perceptors are read in the framework’s directions', () => {
  const senses = readSenses(MESSAGE);

  assert.equal(senses.now, 104.87);
  assert.equal(senses.game.pm, 'BeforeKickOff');
  assert.deepEqual(senses.gyro, [2, -1, 3]);
  assert.deepEqual(senses.acceleration, [0.5, 0, 9.81]);
  assert.deepEqual(senses.feet.lf, { contact: [0.05, -0.01, -0.01], force: [2, -1, 22] });
  assert.deepEqual(senses.heard, [
    { seconds: 12.3, from: 'itself', text: 'hello' },
    { seconds: 12.32, from: 'Blue at -45.5°', text: 'go' },
  ]);
});

test('what the camera sees is read', () => {
  const { seen } = readSenses(MESSAGE);

  assert.deepEqual(
    seen?.things.map(({ name, kind }) => [name, kind]),
    [
      ['G2R', 'post'],
      ['B', 'ball'],
      ['Red 3', 'player'],
    ],
  );
  assert.deepEqual(
    seen?.things[2].points.map(({ name }) => name),
    ['head', 'rlowerarm'],
  );
  assert.deepEqual(seen?.lines, [
    [
      [12.11, -40.77, -2.4],
      [12.95, -37.76, -2.41],
    ],
  ]);
  assert.equal(readSenses('(GYR (n torso) (rt 1 2 3))').seen, undefined);
  assert.deepEqual(readSenses('(See )').seen, { things: [], lines: [] });
});

test('commands are read: motor speeds and said texts', () => {
  const { speeds, said } = readOrders('(lle1 3.14159265)(he2 -1.0)(say hello there)(beam 1 2 3)(syn)');

  assert.ok(Math.abs(speeds.lle1 - 180) < 1e-6);
  assert.ok(Math.abs(speeds.he2 + 57.29578) < 1e-4);
  assert.deepEqual(Object.keys(speeds), ['lle1', 'he2']);
  assert.deepEqual(said, ['hello there']);
});

test('no value is minus zero', () => {
  assert.equal(fixed(-0.04, 1), '0.0');
  assert.equal(fixed(-0.4, 0), '0');
  assert.equal(fixed(-0.06, 1), '-0.1');
});
