import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { gunzipSync } from 'node:zlib';
import { RecordingReader } from '../../main/resources/org/robonewbie/studio/web/state/replay/recording-reader.js';
import { CommandedSpeeds } from '../../main/resources/org/robonewbie/studio/web/state/replay/commanded-speeds.js';
import { RecordedRun } from '../../main/resources/org/robonewbie/studio/web/state/replay/recorded-run.js';
import { RecordingWriter } from '../../main/resources/org/robonewbie/studio/web/state/replay/recording-writer.js';
import {
  advanced,
  atMoment,
  BEGINNING,
  evenly,
  frameOf,
  looped,
  neighbourEvent,
  placeOf,
  sceneOf,
  stepped,
} from '../../main/resources/org/robonewbie/studio/web/state/replay/replay-state.js';
import { tableHead, tableRows } from '../../main/resources/org/robonewbie/studio/web/state/replay/table.js';

const folder = process.env.STUDIO_FRAME_FOLDER ?? '';
const skip = existsSync(join(folder, 'run.rec')) ? false : 'run by Maven';
const read = (/** @type {string} */ name) => readFileSync(join(folder, name));

test('a recording is read like in Java, however its bytes are split', { skip }, () => {
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
    assert.deepEqual([...new Set(reader.events.map(({ kind }) => kind))].sort(), ['goal', 'playmode']);
    const robots = reader.moments.at(-1)?.robots ?? [];
    const columns = tableHead(robots, models).split(',').length;
    assert.equal(columns, 8 + 3 + 22);
    const rows = tableRows(reader.moments, robots, models).trim().split('\n');
    assert.equal(rows.length, reader.moments.filter((moment) => moment.robots === robots).length);
    assert.equal(rows[0].split(',').length, columns);
  }
});

/** @param {Uint8Array} content */
function readAll(content) {
  const reader = new RecordingReader(() => 22);
  reader.push(content);
  return reader;
}

test('a rewritten recording shows the same, without commands', { skip }, () => {
  const before = readAll(gunzipSync(read('run.rec')));
  const writer = new RecordingWriter(before.header, () => 22);

  before.moments.forEach((moment, i) =>
    writer.write(
      moment,
      before.events.filter(({ index }) => index === i),
    ),
  );

  const after = readAll(writer.bytes);
  assert.ok(before.moments.at(-1)?.speeds.size === 1 && after.moments.at(-1)?.speeds.size === 0);
  const content = (/** @type {RecordingReader} */ { moments }) =>
    moments.map(({ cycle, gameTime, game, robots, numbers }) => [cycle, gameTime, game, robots, ...numbers]);
  assert.deepEqual(content(after), content(before));
  assert.deepEqual(after.events, before.events);
  assert.deepEqual(after.header, before.header);
});

test('objects on the pitch are read and written with their poses', () => {
  const game = { playMode: 'PlayOn', half: 1, scoreLeft: 0, scoreRight: 0, left: '', right: '' };
  const at = (/** @type {number} */ x) => Int32Array.of(x, -20, 2000, 20_000, 0, 0, 0);
  const thing = { name: 'box', size: /** @type {[number, number, number]} */ ([0.4, 1.6, 0.4]), movable: true };
  const moments = [-32_000, -32_000, -31_000].map((x, cycle) => ({
    cycle,
    gameTime: 0,
    game,
    robots: [],
    speeds: new CommandedSpeeds(),
    things: [{ thing, grams: 4000, pose: at(x) }],
    numbers: new Int32Array(7),
  }));
  moments[1].things = moments[0].things;
  const writer = new RecordingWriter({}, () => 22);
  moments.forEach((moment) => writer.write(moment, []));
  const moved = Uint8Array.of(9, 9, 0, 0x80, 0x7d, 0, 0, 0, 0, 0, 0);

  const reader = readAll(writer.bytes);

  assert.deepEqual(
    reader.moments.map(({ things }) => things?.[0].pose[0]),
    [-32_000, -32_000, -31_000],
  );
  assert.equal(reader.moments[0].things, reader.moments[1].things);
  const scene = sceneOf(reader.moments[2], {}, {}, 1);
  assert.deepEqual(scene.things, [thing]);
  isNear(frameOf(reader.moments[2], scene).things?.[0] ?? [], [-3.1, -0.002, 0.2, 1, 0, 0, 0], 1e-6);
  reader.push(moved);
  assert.equal(reader.things[0].pose[0], 8000);
});

test('a thinned-out recording keeps its duration', { skip }, () => {
  const before = readAll(gunzipSync(read('run.rec')));
  const writer = new RecordingWriter(before.header, () => 22);
  before.moments
    .filter((_, i) => i % 4 === 0)
    .forEach((moment, i) => writer.write(moment, i === 10 ? [{ index: 0, kind: 'goal', text: 'left Ada' }] : []));

  const after = readAll(writer.bytes);
  const { moments, events } = evenly(after.moments, after.events);

  assert.ok(Math.abs(moments.length - before.moments.length) < 4);
  assert.equal(moments[41].cycle, before.moments[40].cycle);
  assert.equal(events.find(({ kind }) => kind === 'goal')?.index, 40);
});

test('the address names a recording and a moment', () => {
  assert.deepEqual(placeOf('#replay/2026-11-22%2003-04-05@12.5'), {
    name: '2026-11-22 03-04-05',
    seconds: 12.5,
    plays: false,
  });
  assert.deepEqual(placeOf('#replay/me@home'), { name: 'me@home', seconds: undefined, plays: false });
  assert.deepEqual(placeOf('#replay'), { name: '', seconds: undefined, plays: false });
  assert.deepEqual(placeOf('#replay/my%20game@play'), { name: 'my game', seconds: undefined, plays: true });
});

test('pieces are loaded on demand and evicted when there are many', async () => {
  const empty = new RecordingWriter({}, () => 22);
  const game = { playMode: 'PlayOn', half: 1, scoreLeft: 0, scoreRight: 0, left: '', right: '' };
  const numbers = new Int32Array(7);
  for (let cycle = 0; cycle < 10; cycle++) {
    empty.write({ cycle, gameTime: 0, game, robots: [], speeds: new CommandedSpeeds(), numbers }, []);
  }
  const all = empty.bytes;
  const begin = 'RoboNewbie recording\n'.length + 1;
  /** @type {string[]} */
  const asked = [];
  let news = 0;
  const run = new RecordedRun(
    () => 22,
    async (piece, known) => {
      asked.push(`${piece} ${known}`);
      return all.subarray(Math.min(all.length, (piece === 0 ? 0 : begin) + known));
    },
    () => news++,
  );
  run.grow({ count: 1000, whole: true, events: [], pieces: Array.from({ length: 100 }, (_, i) => 10 * i) });

  assert.equal(run.at(995), undefined);
  assert.equal((await run.ready(995))?.cycle, 5);
  assert.equal(news > 0, true);
  await run.ready(985);
  assert.deepEqual(
    run.around(990, 4).map(({ cycle }) => cycle),
    [6, 7, 8, 9, 0, 1, 2, 3, 4],
  );
  assert.equal(asked.length <= 3, true, 'neighbours only');
  let moments = 0;
  for await (const piece of run.all(5, 994)) {
    moments += piece.length;
  }
  assert.equal(moments, 990);
  const before = asked.length;
  await run.ready(5);
  assert.equal(asked.length > before, true, 'the first piece was forgotten');
});

test('other files are refused with a message', () => {
  assert.throws(
    () => new RecordingReader(() => 22).push(new TextEncoder().encode('Hello, this is some other file')),
    /not a RoboNewbie recording/,
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
