import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { believedPlace, seenFrom } from '../../main/resources/org/robonewbie/studio/web/state/robot/robot-facts.js';
import { RobotMemory } from '../../main/resources/org/robonewbie/studio/web/state/robot/robot-memory.js';
import { readTelemetry, robotKey } from '../../main/resources/org/robonewbie/studio/web/state/robot/telemetry.js';

const LINES = [
  'log\t12.34\tBlue\t3\tINFO\tball\\tat 1.20 m\\nnear',
  'motion\t12.36\tBlue\t3\twalk-forward\t4',
  'belief\t12.36\tBlue\t3\t-0.5\t0.4\t-40.0\tball\t1.2\t0.1\t-0.45\t0.5\t1\tRed 1\t2\t0\t0\t3\t0',
  'draw\t12.36\tBlue\t3\tcircle\tred\t1.2\t0.1\t-0.45\t0.1\tline\t#0f0\t0\t0\t0\t1\t1\t0\ttext\tblue\t0\t1\t0\thello',
];

const remembered = (/** @type {string[]} */ ...lines) => {
  const memory = new RobotMemory();
  lines.forEach((line) => memory.receive(line));
  return memory;
};

test('log, motion, belief and drawings of a robot are read', () => {
  const thoughts = remembered(...LINES).at(12.36);

  assert.deepEqual(thoughts.log, [{ seconds: 12.34, level: 'INFO', text: 'ball\tat 1.20 m\nnear' }]);
  assert.deepEqual(thoughts.motion, { name: 'walk-forward', keyframe: 4 });
  assert.deepEqual(thoughts.belief?.self, [-0.5, 0.4, -40]);
  assert.deepEqual(
    thoughts.belief?.things.map(({ name, visible }) => [name, visible]),
    [
      ['ball', true],
      ['Red 1', false],
    ],
  );
  assert.deepEqual(
    thoughts.drawings.map(({ shape }) => shape),
    ['circle', 'line', 'text'],
  );
  assert.equal(thoughts.drawings[2].text, 'hello');
});

test('a plotted value has its robot', () => {
  const parsed = remembered().receive('plot\t12.36\tBlue\t3\tball distance\t1.2');

  assert.equal(parsed?.name, 'ball distance');
  assert.equal(parsed?.value, 1.2);
  assert.equal(readTelemetry(LINES[0]).robot, robotKey('Blue', 3));
});

test('a belief without own pose is read, and a line of another kind is ignored', () => {
  const { belief } = remembered('belief\t1\tBlue\t3\t-\tball\t1\t2\t3\t0\t1', 'dance\t1\tBlue\t3').at(1);

  assert.equal(belief?.self, undefined);
  assert.equal(belief?.things.length, 1);
});

test('drawings of older cycles vanish', () => {
  const memory = remembered('draw\t1\tBlue\t3\tpoint\tred\t0\t0\t0', 'draw\t1.02\tBlue\t3\tpoint\tblue\t0\t0\t0');

  assert.deepEqual(
    memory.at(1).drawings.map(({ colour }) => colour),
    ['red'],
  );
  assert.deepEqual(
    memory.at(1.02).drawings.map(({ colour }) => colour),
    ['blue'],
  );
  assert.deepEqual(
    memory.at(2).drawings.map(({ colour }) => colour),
    ['blue'],
  );
  assert.deepEqual(memory.at(2.04).drawings, []);
});

test('each moment has the telemetry of its time', () => {
  const memory = remembered('motion\t1\tBlue\t3\twave\t1', 'motion\t2\tBlue\t3\twave\t2', 'motion\t3\tBlue\t3\t\t0');
  memory.exchanged({ seconds: 1, perceptors: '(See (B (pol 1 2 3)))', effectors: '' });
  memory.exchanged({ seconds: 1.02, perceptors: '(GYR)', effectors: '(syn)' });

  assert.equal(memory.at(0.5).motion.name, '');
  assert.equal(memory.at(2.5).motion.keyframe, 2);
  assert.equal(memory.at(4).motion.name, '');
  assert.equal(memory.at(1.02).exchange?.effectors, '(syn)');
  assert.equal(memory.at(1.02).picture?.seconds, 1);
  assert.equal(memory.at(5).exchange, undefined);
});

test('a position is converted to the robot’s frame: forward and left', () => {
  const standing = [1, 2, 0.36, 1, 0, 0, 0];
  const [forward, left] = seenFrom(standing, [1, 5]);
  assert.ok(Math.abs(forward - 3) < 1e-9);
  assert.ok(Math.abs(left) < 1e-9);
});

test('the coordinates of the right team are rotated', () => {
  const { position, heading } = believedPlace([-1, -2, 0.36, 1, 0, 0, 0], 'right', [1, 2, -90]);

  assert.ok(Math.hypot(...position) < 1e-9);
  assert.equal(heading, 90);
});

const folder = process.env.STUDIO_FRAME_FOLDER;

test('each line written by Java is parsed with the same meaning', { skip: !folder && 'run by Maven' }, () => {
  const written = JSON.parse(readFileSync(`${folder}/telemetry.json`, 'utf8'));

  for (const { line, team, number, seconds, kind, item } of written) {
    const parsed = readTelemetry(line);
    assert.deepEqual([parsed.seconds, parsed.robot], [seconds, robotKey(team, number)], line);
    assert.deepEqual(MEANINGS[kind](parsed), item, line);
  }
  assert.deepEqual(new Set(written.map(({ kind }) => kind)), new Set(Object.keys(MEANINGS)));
});

/** Formats parsed telemetry like the Java classes. */
const MEANINGS = {
  LogEntry: ({ log: { level, text } }) => ({ level, text }),
  MotionProgress: ({ motion }) => motion,
  Belief: ({ belief: { self, things } }) => ({ self: self ? [self] : [], things }),
  Picture: ({ drawings }) => ({ drawings: drawings.map(meant) }),
  PlotValue: ({ name, value }) => ({ name, value }),
  DeclaredNumber: ({ number }) => number,
};

/** The fields used by a shape. */
function meant({ shape, colour, place, to, radius, text }) {
  const parts = { point: {}, line: { to }, circle: { radius }, text: { text } };
  return { shape, colour, place, ...parts[shape] };
}
