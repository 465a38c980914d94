import assert from 'node:assert/strict';
import test from 'node:test';
import { seenFrom } from '../../main/resources/org/robonewbie/studio/web/state/robot/robot-facts.js';
import { robotKey, withTelemetry } from '../../main/resources/org/robonewbie/studio/web/state/robot/telemetry.js';
import { extentOf, grown, valueAt } from '../../main/resources/org/robonewbie/studio/web/state/robot/traces.js';

const LINES = [
  'log\t12.34\tBlue\t3\tINFO\tball\\tat 1.20 m\\nnear',
  'motion\t12.36\tBlue\t3\twalk-forward\t4',
  'belief\t12.36\tBlue\t3\t-0.5\t0.4\t-40.0\tball\t1.2\t0.1\t-0.45\t0.5\t1\tRed 1\t2\t0\t0\t3\t0',
  'draw\t12.36\tBlue\t3\tcircle\tred\t1.2\t0.1\t-0.45\t0.1\tline\t#0f0\t0\t0\t0\t1\t1\t0\ttext\tblue\t0\t1\t0\thello',
  'plot\t12.36\tBlue\t3\tball distance\t1.2',
];

test('log, motion, belief, drawings and values of a robot are read', () => {
  const thoughts = withTelemetry(new Map(), LINES).get(robotKey('Blue', 3));
  assert.deepEqual(thoughts?.log, [{ seconds: 12.34, level: 'INFO', text: 'ball\tat 1.20 m\nnear' }]);
  assert.deepEqual(thoughts?.motion, { name: 'walk-forward', keyframe: 4 });
  assert.deepEqual(thoughts?.belief?.self, [-0.5, 0.4, -40]);
  assert.deepEqual(thoughts?.belief?.things.map(({ name, visible }) => [name, visible]), [['ball', true], ['Red 1', false]]);
  assert.deepEqual(thoughts?.picture.drawings.map(({ shape }) => shape), ['circle', 'line', 'text']);
  assert.equal(thoughts?.picture.drawings[2].text, 'hello');
  assert.equal(thoughts?.values['ball distance'], 1.2);
});

test('a belief without own place is read, and a line of another kind is left out', () => {
  const all = withTelemetry(new Map(), ['belief\t1\tBlue\t3\t-\tball\t1\t2\t3\t0\t1', 'dance\t1\tBlue\t3']);
  assert.equal(all.get(robotKey('Blue', 3))?.belief?.self, undefined);
  assert.equal(all.get(robotKey('Blue', 3))?.belief?.things.length, 1);
});

test('a robot that looks along y sees the world turned', () => {
  const alongY = [1, 1, 0.3, 1, 0, 0, 0];
  const [forward, left] = seenFrom(alongY, [1, 3]);
  assert.ok(Math.abs(forward - 2) < 1e-9 && Math.abs(left) < 1e-9);
  assert.ok(Math.abs(seenFrom(alongY, [0, 1])[1] - 1) < 1e-9);
});

test('curves keep the last seconds and begin anew after a reset', () => {
  const at = (/** @type {number} */ value) => [{ name: 'a', unit: '°', value }];
  let traces = grown([], 0, at(1));
  traces = grown(traces, 1, at(5));
  traces = grown(traces, 1, at(9));
  assert.deepEqual(traces[0].points, [[0, 1], [1, 5]]);
  assert.equal(valueAt(traces[0], 0.5), 1);
  assert.equal(extentOf(traces).to, 1);
  assert.equal(grown(traces, 30, at(2))[0].points.length, 1);
  assert.equal(grown(traces, 0.5, at(2))[0].points.length, 1);
});
