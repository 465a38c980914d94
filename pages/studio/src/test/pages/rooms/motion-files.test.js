/** Motions come from files of other programs, of RoboNewbie 1.1 and of recordings, and go to files of other programs. */
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { folderWith } from '../stage.js';
import { slow } from '../tests.js';
import { answers, fileOf, keyframesIn, openMotion, saves, seesKeyframes, STANDING } from './motion-room.js';

const LEFT_HIP = 9; // the first number of a line is the time
const TWO_KEYFRAMES = `500 ${STANDING}\n1000 ${STANDING.replace('0 0 -90', '0 12.5 -90')}\n`;
const STILL = `200${' 0'.repeat(22)}\n400${' 0'.repeat(22)}\n`;
const SKIPPED = `400${' 0'.repeat(22)}\r\n20${' 1'.repeat(22)}\r\n400${' 2'.repeat(22)}\r\n`;
const OLD = 'This motion seems to have been written for RoboNewbie 1.1';

/** Chooses a file for the button Import…. */
async function imports(t, user, name, content) {
  const folder = await folderWith(t, { [name]: content });
  const [chooser] = await Promise.all([user.page.waitForFileChooser(), user.clicks('button', 'Import…')]);
  await chooser.accept([join(folder, name)]);
}

slow('a motion that is exported to Webots and imported is the same', async (t) => {
  const studio = await openMotion(t, { files: { mine: TWO_KEYFRAMES } });
  const { user } = studio;

  await user.clicks('button', 'Motion ▾');
  await user.clicks('button', 'Export…');
  await user.readsValue('combobox', 'For', 'webots');
  const { name, bytes } = await user.downloads(() => user.clicks('button', 'Export'));
  await imports(t, user, 'theirs.motion', bytes);
  await user.sees('Keyframes imported from theirs.motion: 2.');
  await user.clicks('button', 'Save');
  await answers(user, 'theirs');
  await user.sees('Saved.');

  assert.equal(name, 'mine.motion');
  assert.match(String(bytes), /^#WEBOTS_MOTION,V1\.0,HeadYaw,HeadPitch,[^]*Pose2/);
  assert.deepEqual(keyframesIn(await fileOf(studio, 'theirs')), keyframesIn(TWO_KEYFRAMES));
});

slow('the posture of a recorded moment becomes a keyframe', async (t) => {
  const files = { mine: TWO_KEYFRAMES };
  const studio = await openMotion(t, { room: 'replay/game', recordings: ['game'], files });
  const { user } = studio;
  await user.sees('0.00 of 4.18 s');
  await user.presses('End');
  await user.sees('4.18 of 4.18 s');
  await user.clicks('link', 'Robot');
  const leg = await user.reads('region', 'Left leg', /Hip pitch\s+\d{3}/);
  const hip = Number(/Hip pitch\s+([0-9.]+)/.exec(leg)?.[1]);

  await user.clicks('link', 'Motion');
  await user.clicks('button', 'mine');
  await user.clicks('button', 'Capture posture');

  const keyframes = await saves(studio);
  assert.equal(keyframes.length, 3);
  assert.ok(Math.abs(keyframes[1][LEFT_HIP] - hip) <= 0.06, `${keyframes[1][LEFT_HIP]}, not ${hip}`);
});

slow('a name may have letters of any language, and an invalid one is reported', async (t) => {
  const { user, folder } = await openMotion(t, { files: { mine: STILL } });
  await user.clicks('button', '+ New');
  await user.clicks('button', 'Save');

  await user.fills('textbox', 'Name', 'left/right');
  await user.sees('The name contains "/".');
  assert.ok(await (await user.finds('button', 'Save')).evaluate((button) => button.disabled));
  await answers(user, 'gru\u0308ßen 手を振る');

  await user.finds('button', 'grüßen 手を振る');
  assert.ok(existsSync(join(folder, 'grüßen 手を振る.txt')));
});

slow('a file that cannot be played is listed with the reason', async (t) => {
  const { user } = await openMotion(t, { files: { mine: STILL, 'what?': SKIPPED } });

  await user.sees('The name of the file what?.txt contains "?". Rename it.');
});

slow('bytes that are no text are refused and stay', async (t) => {
  const bytes = Buffer.from(`${SKIPPED}// \u0081`, 'latin1');
  const { user, folder } = await openMotion(t, { motion: 'odd', files: { odd: bytes } });

  await user.sees('odd.txt cannot be opened: line 4 is neither UTF-8 nor Windows-1252 (byte 0x81).');

  await user.sees(/^wave$/m);
  assert.deepEqual(await readFile(join(folder, 'odd.txt')), bytes);
});

slow('an imported motion of RoboNewbie 1.1 is saved with the rule that plays it as then', async (t) => {
  const studio = await openMotion(t, { files: { mine: STILL } });
  const { user, visit } = studio;
  await imports(t, user, 'old walk.txt', SKIPPED);

  await user.sees(OLD);
  await user.clicks('button', 'Play it as RoboNewbie 1.1 did');
  await user.seesNo(OLD);
  await user.clicks('button', 'Save');
  await answers(user, 'old walk');

  await user.sees('Saved.');
  assert.equal(await fileOf(studio, 'old walk'), `// play: 1.1\r\n${SKIPPED}`);
  await visit('motion/old%20walk');
  await seesKeyframes(user, 400, 420, 820);
  assert.ok(!(await user.text()).includes(OLD));
});

slow('a motion of RoboNewbie 1.1 may be left as it is', async (t) => {
  const studio = await openMotion(t, { motion: 'old', files: { old: SKIPPED } });
  const { user } = studio;

  await user.sees(OLD);
  await user.clicks('button', 'Leave it as it is');

  await user.seesNo(OLD);
  assert.equal(await fileOf(studio, 'old'), SKIPPED);
});

slow('an import without effect is refused', async (t) => {
  const { user } = await openMotion(t, { files: { mine: STILL } });

  await imports(t, user, 'theirs.motion', '#WEBOTS_MOTION,V1.0,l_knee\n00:01:000,Pose1,1.2\n');

  await user.sees('theirs.motion was not imported: line 1 names no joint of this robot: found “l_knee”.');
  await seesKeyframes(user, 200, 600);
});
