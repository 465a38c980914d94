import assert from 'node:assert/strict';
import test from 'node:test';
import {
  ALL_DRAWINGS,
  DrawingLayers,
  layerOf,
} from '../../main/resources/org/robonewbie/studio/web/state/drawing-layers.js';
import {
  isDrawable,
  onGround,
  standOf,
  trianglesOf,
} from '../../main/resources/org/robonewbie/studio/web/state/drawing-shapes.js';
import { picturesOf } from '../../main/resources/org/robonewbie/studio/web/state/replay/notes.js';
import { DrawingMemory } from '../../main/resources/org/robonewbie/studio/web/state/robot/drawing-memory.js';

const near = (/** @type {number[]} */ actual, /** @type {number[]} */ expected) =>
  actual.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < 1e-6, `${actual} is not ${expected}`));
const drawing = (/** @type {object} */ given) => ({
  shape: 'point',
  colour: 'red',
  place: [0, 0, 0],
  to: [0, 0, 0],
  radius: 0,
  text: '',
  ...given,
});
const picture = (/** @type {number} */ seconds, /** @type {string} */ colour, team = 'Blue') =>
  `draw\t${seconds}\t${team}\t1\tpoint\t${colour}\t0\t0\t0`;

/** A torso whose forward direction, y, points along the world's x, and a head above it. */
const EAST = [1, 2, 0.4, Math.SQRT1_2, 0, 0, -Math.SQRT1_2, 1.5, 2, 0.6, 1, 0, 0, 0];

test('head coordinates are transformed to the world in any posture', () => {
  const east = standOf(EAST, 1);
  near(onGround(east, [2, 0]), [3.5, 2]);
  near(onGround(east, [0, 1]), [1.5, 3]);

  const north = standOf([1, 2, 0.4, 1, 0, 0, 0], 0);
  near(onGround(north, [2, 0]), [1, 4]);
  near(onGround(north, [0, 1]), [0, 2]);
});

test('a line is a ribbon, a circle a ring of its radius, a point a disc, a text no triangle', () => {
  const stand = standOf(EAST, 1);
  const line = trianglesOf(stand, drawing({ shape: 'line', to: [2, 0, 0] }));
  assert.equal(line.length, 12);
  near([Math.min(...line.filter((_, i) => i % 2 === 0)), Math.max(...line.filter((_, i) => i % 2 === 0))], [1.5, 3.5]);
  near([Math.max(...line.filter((_, i) => i % 2 === 1))], [2 + 0.0175]);

  const circle = trianglesOf(stand, drawing({ shape: 'circle', place: [1, 0, 0], radius: 0.5 }));
  for (let i = 0; i < circle.length; i += 2) {
    assert.ok(Math.abs(Math.hypot(circle[i] - 2.5, circle[i + 1] - 2) - 0.5) < 0.018);
  }
  assert.ok(trianglesOf(stand, drawing({})).length > 0);
  assert.deepEqual(trianglesOf(stand, drawing({ shape: 'text' })), []);
});

test('a line without length and invalid numbers are ignored', () => {
  assert.ok(trianglesOf(standOf(EAST, 1), drawing({ shape: 'line' })).every(Number.isFinite));
  assert.equal(isDrawable(drawing({})), true);
  assert.equal(isDrawable(drawing({ radius: NaN })), false);
  assert.equal(isDrawable(drawing({ to: [1, Infinity, 0] })), false);
});

test('a layer is off if it, its robot or the root is off', () => {
  const layers = new DrawingLayers([layerOf('Blue\t1', 'text')]);
  const seen = () => ['text', 'line'].map((kind) => layers.shows('Blue\t1', kind));

  assert.deepEqual(seen(), [false, true]);
  layers.set('Blue\t1', false);
  assert.deepEqual(seen(), [false, false]);
  assert.equal(layers.shows('Blue\t11', 'line'), true);
  layers.set('Blue\t1', true);
  layers.set(ALL_DRAWINGS, false);
  assert.deepEqual(seen(), [false, false]);
  assert.equal(layers.shows('Blue\t11', 'line'), false);
  layers.set(ALL_DRAWINGS, true);
  assert.deepEqual(seen(), [false, true]);
});

test('a drawing lasts until the next one of its robot, for at most one second', () => {
  const memory = new DrawingMemory();
  memory.receive([
    picture(1, 'red'),
    'log\t1\tBlue\t1\tINFO\thello',
    picture(1.5, 'blue'),
    picture(1.2, 'lime', 'Red'),
  ]);
  const colours = (/** @type {string} */ robot, /** @type {number[]} */ ...times) =>
    times.map((time) => memory.at(robot, time).map(({ colour }) => colour)[0]);

  assert.deepEqual(colours('Blue\t1', 0.9, 1, 1.48, 1.5, 2.48, 2.5), [
    undefined,
    'red',
    'red',
    'blue',
    'blue',
    undefined,
  ]);
  assert.deepEqual(colours('Red\t1', 1, 1.5), [undefined, 'lime']);
  assert.deepEqual([...memory.kinds.keys()], ['Blue\t1', 'Red\t1']);
});

test('drawings of a restarted time base replace earlier ones', () => {
  const memory = new DrawingMemory();
  memory.receive([picture(100, 'red'), picture(1, 'blue')]);

  assert.equal(memory.at('Blue\t1', 1)[0].colour, 'blue');
  assert.equal(memory.at('Blue\t1', 100).length, 0);
});

test('drawings are read from the notes of a recording', () => {
  const lines = [
    JSON.stringify({ drawn: picture(1, 'red') }),
    '{"seconds":1,"robot":"Blue 1","level":"INFO"}',
    '{"dra',
  ];

  assert.deepEqual(picturesOf(lines.join('\n')), [picture(1, 'red')]);
  assert.deepEqual(picturesOf(''), []);
});
