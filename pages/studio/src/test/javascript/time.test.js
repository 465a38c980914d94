import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { Traces, tableOf } from '../../main/resources/org/robonewbie/studio/web/state/robot/traces.js';
import { TimeCursor } from '../../main/resources/org/robonewbie/studio/web/state/time-cursor.js';
import { readFrame } from '../../main/resources/org/robonewbie/studio/web/live/state-frame.js';

const folder = process.env.STUDIO_FRAME_FOLDER;

test('late values of a cycle find their row', () => {
  const traces = new Traces();
  traces.add(10, [['a', 1]]);
  traces.add(12, [['a', 3]]);
  traces.add(10, [['b', 5]]);
  traces.add(11, [['b', 6]]);

  assert.deepEqual(traces.columns(['a', 'b', 'none'], 0, 1), [
    [0.2, 0.22, 0.24],
    [1, null, 3],
    [5, 6, null],
    [null, null, null],
  ]);
  assert.equal(traces.valueAt('a', 0.23), 1);
  assert.equal(traces.valueAt('a', 0.1), undefined);
  assert.equal(tableOf(traces, ['a', 'b'], 0, 1), 'seconds,a,b\n0.20,1,5\n0.22,,6\n0.24,3,\n');
});

test('only the requested part of long curves is returned', () => {
  const traces = new Traces();
  for (let cycle = 0; cycle < 20_000; cycle++) {
    traces.add(cycle, [['a', cycle]]);
  }

  assert.ok(traces.rows.length <= 16_500);
  const [seconds] = traces.columns(['a'], 300, 301);
  assert.ok(seconds.length >= 50 && seconds.length <= 53);
  assert.equal(traces.valueAt('a', 399.98), 19_999);
});

test(
  'the cursor goes back while the simulation continues, and returns to the present',
  { skip: folder ? false : 'run by Maven' },
  () => {
    const scene = JSON.parse(readFileSync(join(String(folder), 'scene.json'), 'utf8'));
    const bytes = new Uint8Array(readFileSync(join(String(folder), 'frame.bin'))).buffer;
    const cursor = new TimeCursor();
    const frameAt = (/** @type {number} */ cycle) => {
      const copy = bytes.slice(0);
      new DataView(copy).setUint32(4, cycle, true);
      return copy;
    };
    for (let cycle = 100; cycle <= 200; cycle += 2) {
      cursor.history.push(cycle, scene, frameAt(cycle));
    }
    const live = /** @type {any} */ ({ scene, frame: readFrame(frameAt(200), scene) });

    assert.equal(cursor.shown(live).tense, 'live');
    cursor.goTo(151);
    cursor.history.push(202, scene, frameAt(202));
    assert.equal(cursor.shown(live).tense, 'past');
    assert.equal(cursor.shown(live).frame?.cycle, 150);
    cursor.step(10);
    assert.equal(cursor.shown(live).frame?.cycle, 160);
    cursor.goTo(3);
    assert.equal(cursor.shown(live).frame?.cycle, 100);
    cursor.goTo(900);
    assert.equal(cursor.shown(live).tense, 'live');
    cursor.goTo(150);
    cursor.goToRecorded(/** @type {any} */ ({ name: 'run', scene, frame: live.frame }));
    assert.equal(cursor.shown(live).tense, 'recorded');
    cursor.goLive();
    assert.equal(cursor.shown(live).tense, 'live');
  },
);
