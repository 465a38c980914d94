/** Random clicks, keys and drags in each room cause no error, and no file is lost or corrupted. */
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { slow } from '../tests.js';
import { openStudio } from '../user.js';

const SEED = 20261122;
const SCRIPT = readFileSync(new URL('../../tools/fuzz-page.js', import.meta.url), 'utf8');
const ROOMS = ['field', 'field/exercises', 'program', 'robot', 'motion/mine', 'replay/game'];
const CLICKS_PER_CALL = 500;
const MAX_HEAP_BYTES = 300_000_000;

/** Steps with real events of mouse and keyboard, which change focus and scroll as a user's do, but are slow. */
const REAL_STEPS = 25;
const KEYS = 'abcdefghijklmnopqrstuvwxyz0123456';

/** Expected refusals: invalid name (400), missing recording (404), name in use (409). */
const REFUSED = /status of 4(00|04|09)/;

const KEYFRAME = `200${' 0'.repeat(22)}\n`;

/** Returns a function that returns whole numbers below an end, always the same ones (mulberry32). */
function chances(seed) {
  let state = seed;
  return (end) => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return Math.floor(((mixed ^ (mixed >>> 14)) >>> 0) * (end / 2 ** 32));
  };
}

async function takesAStep(user, below) {
  if (below(3) === 0) {
    await user.presses(KEYS[below(KEYS.length)]);
    return;
  }
  const [x, y] = [below(1366), 60 + below(700)];
  await user.drags([x, y], [x + below(120) - 60, y + below(120) - 60]);
}

/** Checks the files: a recording may have another name or be in the bin, motions and programs may have changed. */
function filesAreSafe(folder, recording) {
  assert.notEqual(readFileSync(join(folder, 'Student.java'), 'utf8'), '');
  assert.match(readFileSync(join(folder, 'mine.txt'), 'utf8'), /^\d+( [-\d.]+){22}/m);
  const recordings = readdirSync(folder, { recursive: true }).filter((name) => /\.rec($|\W)/.test(name));
  assert.ok(
    recordings.some((name) => readFileSync(join(folder, name)).equals(recording)),
    `the recording is none of ${recordings}`,
  );
}

for (const clicks of [500, ...(process.env.CLICKS ? [Number(process.env.CLICKS)] : [])]) {
  for (const room of ROOMS) {
    slow(`${clicks} random clicks in #${room} cause no error and lose no file`, async (t) => {
      const files = { 'mine.txt': KEYFRAME + KEYFRAME, 'Student.java': '// mine' };
      const { user, folder } = await openStudio(t, { room, files, robots: [{}], recordings: ['game'] });
      user.expectsComplaints(REFUSED);
      const recording = readFileSync(join(folder, 'game.rec'));
      const below = chances(SEED);
      for (let i = 0; i < REAL_STEPS; i++) {
        await takesAStep(user, below);
      }

      await user.page.evaluate(`${SCRIPT}; true`);
      for (let done = 0; done < clicks; done += CLICKS_PER_CALL) {
        await user.page.evaluate((...how) => window.fuzz(...how), below(2 ** 31), CLICKS_PER_CALL, `#${room}`);
        const bytes = await user.page.evaluate(() => performance.memory.usedJSHeapSize);
        assert.ok(bytes < MAX_HEAP_BYTES, `${bytes} bytes of the heap after ${done} clicks`);
      }

      filesAreSafe(folder, recording);
    });
  }
}
