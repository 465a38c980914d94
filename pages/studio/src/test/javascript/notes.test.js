import assert from 'node:assert/strict';
import test from 'node:test';
import { notesOf } from '../../main/resources/org/robonewbie/studio/web/state/replay/notes.js';

/** @param {number} seconds @param {string} level @param {string} text */
const line = (seconds, level, text) => JSON.stringify({ seconds, robot: 'Blue 1', level, text });

test('warnings and log lines become events at their cycles', () => {
  const events = notesOf(
    `${line(1.02, 'INFO', 'I see the ball')}\n${line(2, 'WARNING', 'too fast')}\n${line(2, 'ERROR', 'no')}\n`,
    1,
  );

  assert.deepEqual(events, [
    { index: 50, kind: 'log', text: 'Blue 1 says I see the ball' },
    { index: 99, kind: 'warning', text: 'Blue 1 says too fast' },
    { index: 99, kind: 'warning', text: 'Blue 1 says no' },
  ]);
});

test('an incomplete line is skipped', () => {
  assert.deepEqual(notesOf(line(1, 'INFO', 'all').slice(0, -4), 0), []);
  assert.deepEqual(notesOf('', 0), []);
});
