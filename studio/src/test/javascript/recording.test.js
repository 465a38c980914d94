import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { gunzipSync } from 'node:zlib';
import { RecordingReader } from '../../main/resources/org/robonewbie/studio/web/state/replay/recording-reader.js';
import { withoutCommands } from '../../main/resources/org/robonewbie/studio/web/state/replay/recording-source.js';
import {
  advanced,
  atMoment,
  BEGINNING,
  csvOf,
  frameOf,
  looped,
  neighbourEvent,
  sceneOf,
  stepped,
} from '../../main/resources/org/robonewbie/studio/web/state/replay/replay-state.js';

const folder = process.env.STUDIO_FRAME_FOLDER ?? '';
const skip = existsSync(join(folder, 'run.rec')) ? false : 'run by Maven';
const read = (/** @type {string} */ name) => readFileSync(join(folder, name));

test('a recording is understood as by the reader in Java, however its bytes come', { skip }, () => {
  const models = { TYPE_0: JSON.parse(read('robot.json').toString()).model };
  const bytes = gunzipSync(read('run.rec'));
  const truth = JSON.parse(read('run.json').toString());
  for (const size of [bytes.length, 1000, 7]) {
    const reader = new RecordingReader(() => models.TYPE_0.hinges.length);
    for (let at = 0; at < bytes.length; at += size) {
      reader.push(bytes.subarray(at, at + size));
    }
    assert.equal(reader.moments.length, truth.length);
    reader.moments.forEach((moment, i) => {
      const frame = frameOf(moment, sceneOf(moment, reader.header, models, 1));
      assert.equal(moment.cycle, truth[i].cycle);
      assert.equal(frame.scoreLeft, truth[i].scoreLeft);
      isNear(frame.ball.slice(0, 3), truth[i].ball, 1e-4);
      frame.robots.forEach((robot, k) => {
        isNear(robot.degrees, truth[i].degrees[k], 0.006);
        isNear(robot.torso, truth[i].torsos[k], 1e-3);
      });
    });
    assert.equal(sceneOf(reader.moments[0], reader.header, models, 1).field.length, 12);
    assert.deepEqual([...new Set(reader.events.map(({ kind }) => kind))].sort(), ['fall', 'goal', 'playmode']);
    assert.equal(csvOf(reader.moments, models).split('\n')[0].split(',').length, 8 + 3 + 22);
  }
});

test('without its commands a recording shows the same, also where it ends in the middle', { skip }, () => {
  const bytes = gunzipSync(read('run.rec'));
  const readAll = (/** @type {Uint8Array} */ content) => {
    const reader = new RecordingReader(() => 22);
    reader.push(content);
    return reader;
  };
  for (const whole of [bytes, bytes.subarray(0, bytes.length - 10)]) {
    const before = readAll(whole);
    const left = Buffer.concat(withoutCommands(whole));
    const after = readAll(left);
    assert.ok(left.length < whole.length);
    assert.ok(before.moments.at(-1)?.speeds.size === 1 && after.moments.at(-1)?.speeds.size === 0);
    assert.deepEqual(
      after.moments.map(({ numbers, gameTime }) => [gameTime, ...numbers]),
      before.moments.map(({ numbers, gameTime }) => [gameTime, ...numbers]),
    );
    assert.deepEqual(after.events, before.events);
  }
});

test('something else is refused in plain words', () => {
  assert.throws(
    () => new RecordingReader(() => 22).push(new TextEncoder().encode('Hello, this is some other file')),
    /not a recording/,
  );
});

test('the replay plays, stops at the end and repeats a part', () => {
  const state = { ...BEGINNING, count: 1000, playing: true };
  assert.equal(advanced(state, 2).index, 100);
  assert.deepEqual([advanced(state, 60).index, advanced(state, 60).playing], [999, false]);
  const repeating = looped(atMoment(state, 500));
  assert.deepEqual(repeating.loop, [400, 600]);
  assert.equal(advanced(atMoment(repeating, 599), 1).index, 400);
  assert.equal(looped(repeating).loop, undefined);
  assert.deepEqual([stepped(state, 1).index, stepped(state, 1).playing, stepped(state, -1).index], [1, false, 0]);
});

test('events are found forwards and backwards', () => {
  const events = [10, 20, 30].map((index) => ({ index, kind: /** @type {const} */ ('goal'), text: 'Ada' }));
  const state = atMoment({ ...BEGINNING, count: 100 }, 20);
  assert.equal(neighbourEvent(state, events, 1)?.index, 30);
  assert.equal(neighbourEvent(state, events, -1)?.index, 10);
  assert.equal(neighbourEvent(atMoment(state, 30), events, 1), undefined);
});

/** @param {ArrayLike<number>} actual @param {number[]} expected @param {number} tolerance */
function isNear(actual, expected, tolerance) {
  expected.forEach((value, i) =>
    assert.ok(Math.abs(actual[i] - value) <= tolerance, `${i}: ${actual[i]} is not ${value}`),
  );
}
