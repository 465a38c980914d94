/** A student shapes a motion of the robot by mouse and keys, tries it, saves it, and shares the folder with other programs. */
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { quick, slow } from '../tests.js';
import { newUser, openStudio } from '../user.js';
import {
  answers,
  fileOf,
  keepsADraft,
  keyframesIn,
  openMotion,
  pointOfLimb,
  readsAngle,
  saves,
  seesKeyframes,
  STANDING,
  turns,
  types,
} from './motion-room.js';

const WAVE = new URL('../../../../../../core/robot/src/main/resources/motions/wave.txt', import.meta.url);
const TIME = 'Time to reach this keyframe in milliseconds';
const LEFT_KNEE = 10; // the first number of a line is the time
const ONE_KEYFRAME = `500 ${STANDING}\n`;
const WITH_COMMENTS = `// author: Ada\r\n\r\n500\t${STANDING}   // begin\r\nnonsense\r\n1000 ${STANDING.replace('-25', '-25.500')}\r\n`;

const openMine = (t, text, options = {}) => openMotion(t, { files: { mine: text }, ...options });
const writeMine = ({ folder }, text) => writeFile(join(folder, 'mine.txt'), text);

/** Returns the positions in a line at which two keyframes differ: 1 for the first joint, because the time comes first. */
const changesIn = (line, before) => line.flatMap((number, i) => (number === before[i] ? [] : [i]));

/** Ends the process of the page, which has no time to save anything. */
async function crashes({ page }) {
  const session = await page.createCDPSession();
  const crash = new Promise((done) => session.once('Inspector.targetCrashed', done));
  await session.send('Inspector.enable');
  session.send('Page.crash').catch(() => undefined);
  await crash;
}

/** Holds the request for an address back until the test continues it. */
async function held({ page }, address) {
  const late = { request: undefined };
  await page.setRequestInterception(true);
  page.on('request', (request) => {
    if (request.url().endsWith(address)) {
      late.request = request;
    } else {
      void request.continue();
    }
  });
  return late;
}

quick('a new motion is shaped, played, saved and found by its name', async (t) => {
  const studio = await openMotion(t, { motion: 'wave' });
  const { user } = studio;
  await user.clicks('button', '+ New');
  await seesKeyframes(user, 500);

  const [x, y] = await pointOfLimb(user, 'rupperarm');
  await user.drags([x, y], [x - 60, y - 60]);
  await user.clicks('button', '+ Keyframe');
  await turns(user, 'neck yaw', '30');
  await user.clicks('button', 'Duplicate');
  await seesKeyframes(user, 500, 1000, 1500);
  await types(user, TIME, '240');
  await user.clicks('button', '▶ Play');
  await user.sees('1.24 s of 1.24 s');
  await user.finds('button', '▶ Play');
  await user.clicks('button', 'Save');
  await answers(user, 'my-first');

  await user.finds('button', 'my-first');
  const keyframes = keyframesIn(await fileOf(studio, 'my-first'));
  assert.equal(keyframes.map(([millis, neckYaw]) => `${millis} ${neckYaw}`).join(), '500 0,500 30,240 30');
});

slow('a motion of the library is shown with its keyframes and its balance', async (t) => {
  const { user } = await openMotion(t, { motion: 'wave' });
  let time = 0;
  const times = keyframesIn(await readFile(WAVE, 'utf8')).map(([millis]) => (time += millis));

  assert.ok(times.length > 1);
  await seesKeyframes(user, ...times);
  await user.sees(/[0-9.]+ cm inside the feet$/m);
});

for (const [title, way, keys, turned, mayTurn] of [
  ['a dragged forearm turns its elbow only', [5, -70], [], [], [5, 6]],
  ['a dragged hand takes the whole arm along while Shift is held', [30, -90], ['Shift'], [3, 6], [3, 4, 5, 6]],
]) {
  slow(title, async (t) => {
    const studio = await openMine(t, ONE_KEYFRAME);
    const [x, y] = await pointOfLimb(studio.user, 'llowerarm');

    await studio.user.drags([x, y], [x + way[0], y + way[1]], ...keys);

    const [keyframe] = await saves(studio);
    const changes = changesIn(keyframe, keyframesIn(ONE_KEYFRAME)[0]);
    assert.ok(changes.length > 0);
    assert.ok(turned.every((joint) => changes.includes(joint)));
    assert.ok(changes.every((joint) => mayTurn.includes(joint)));
    assert.equal(await studio.user.page.$('#motion-joints .beyond'), null);
  });
}

slow('copied keyframes are pasted into another motion', async (t) => {
  const other = `700 ${STANDING.replace('0 0 -90', '33 0 -90')}\n`;
  const studio = await openMotion(t, { motion: 'other', files: { other } });
  const { user } = studio;

  await user.clicks('button', 'Copy');
  await user.sees('1 keyframe copied');
  await writeMine(studio, WITH_COMMENTS);
  await user.clicks('button', 'mine');
  await seesKeyframes(user, 500, 1500);
  await user.clicks('button', 'Paste');

  await seesKeyframes(user, 500, 1200, 2200);
  await readsAngle(user, 'neck yaw', '33');
});

slow('a posture that is kept is in the list and on the disk', async (t) => {
  const { user, folder } = await openMine(t, ONE_KEYFRAME);

  await user.clicks('button', 'Save this posture…');
  await answers(user, 'look-left');

  await user.finds('button', 'look-left');
  assert.match(await readFile(join(folder, '.studio', 'poses.txt'), 'utf8'), /look-left/);
});

slow('a typed angle keeps its decimals, undo brings the old one back, and the rest of the file stays', async (t) => {
  const studio = await openMine(t, WITH_COMMENTS);
  const { user } = studio;

  await turns(user, 'left knee pitch', '-61.375');
  await user.clicks('button', '↶ Undo');
  await readsAngle(user, 'left knee pitch', '-50');
  await user.clicks('button', '↷ Redo');
  await readsAngle(user, 'left knee pitch', '-61.375');
  await saves(studio);

  assert.equal(await fileOf(studio), WITH_COMMENTS.replace('-50', '-61.375'));
});

slow('an unchanged file is saved byte for byte', async (t) => {
  const text = `\uFEFF${WITH_COMMENTS}`.replace('Ada', 'Zoë');
  const studio = await openMine(t, text);

  await studio.user.clicks('button', 'Save');
  await studio.user.sees('Saved.');

  assert.equal(await fileOf(studio), text);
});

slow('a new motion is not replaced by one that arrives late', async (t) => {
  const { user } = await openStudio(t);
  const late = await held(user, 'library/wave');

  await user.clicks('link', 'Motion');
  await user.until(() => late.request);
  await (await user.finds('button', '+ New')).click();
  await late.request.continue();
  await user.clicks('button', 'Duplicate');

  await seesKeyframes(user, 500, 1000);
  await user.sees('new motion •');
});

slow('a physical robot falls when the motion throws it over', async (t) => {
  const over = STANDING.replaceAll('25 -50 25', '90 -50 60');
  const { user } = await openMine(t, `200 ${over}\n1000 ${over}\n`);

  await user.clicks('button', 'Try with physics');

  await user.sees(/With physics, the robot falls after (0\.[2-9]|1\.|2\.[01])\d* s/);
});

slow('a physical robot stays on its feet when it stands', async (t) => {
  const { user } = await openMine(t, ONE_KEYFRAME);

  await user.clicks('button', 'Try with physics');

  await user.sees('The robot stays on its feet.');
});

slow('unsaved work survives a crash of the browser, and undo discards it', async (t) => {
  const studio = await openMine(t, WITH_COMMENTS);
  await turns(studio.user, 'neck pitch', '12.5');
  await keepsADraft(studio);
  await crashes(studio.user);

  const user = await newUser(t);
  await user.visits(`${await studio.stage.address()}#motion/mine`);

  await user.sees('Unsaved work on “mine” was recovered.');
  await readsAngle(user, 'neck pitch', '12.5');
  assert.equal(await fileOf(studio), WITH_COMMENTS);
  await user.clicks('button', '↶ Undo');
  await readsAngle(user, 'neck pitch', '0');
});

slow('a change of the file by another program is shown at once', async (t) => {
  const studio = await openMine(t, WITH_COMMENTS);
  await seesKeyframes(studio.user, 500, 1500);

  await writeMine(studio, `700 ${STANDING}\n`);

  await seesKeyframes(studio.user, 700);
});

slow('the user decides between unsaved work and a change by another program', async (t) => {
  const studio = await openMine(t, WITH_COMMENTS);
  const { user } = studio;
  user.expectsComplaints(/409 \(Conflict\)/);
  await turns(user, 'neck pitch', '12.5');
  await writeMine(studio, `700 ${STANDING}\n`);
  await user.sees('This file was changed by another program and also has unsaved changes here.');
  await user.clicks('button', 'Save');
  await user.sees(/changed by another program[^]*changed by another program/);

  await user.clicks('button', 'Load theirs');
  await seesKeyframes(user, 700);
  await readsAngle(user, 'neck pitch', '0');
  await user.clicks('button', '↶ Undo');

  await readsAngle(user, 'neck pitch', '12.5');
});

slow('a dragged keyframe changes its time', async (t) => {
  const studio = await openMine(t, WITH_COMMENTS);
  const keyframe = await studio.user.finds('image', 'Keyframe 2 at 1.50 s');
  const { x, y, width, height } = await keyframe.boundingBox();
  const [middle, low] = [x + width / 2, y + height - 6];

  await studio.user.drags([middle, low], [middle - 100, low]);

  const [, [millis]] = await saves(studio);
  assert.ok(millis < 1000);
  assert.equal(millis % 20, 0);
});

slow('a way that is too fast for a motor is marked', async (t) => {
  const { user } = await openMine(t, `${ONE_KEYFRAME}20 ${STANDING.replace('0 0 -90', '90 0 -90')}\n`);

  await user.clicks('button', 'too fast 1');

  await user.sees('neck yaw turns 90° in 20 ms; its motor needs 260 ms');
});

slow('the posture of a robot of the running world becomes a keyframe', async (t) => {
  const studio = await openMine(t, ONE_KEYFRAME, { robots: [{}], isPaused: true });
  const { user, stage, visit } = studio;
  const { cycle } = await stage.world();
  await stage.order({ do: 'step', cycles: 150 });
  await user.until(async () => (await stage.world()).cycle >= cycle + 150);
  await visit();

  await user.clicks('button', 'Capture posture');

  const keyframes = await saves(studio);
  const { robots } = await stage.world();
  assert.equal(keyframes.length, 2);
  assert.ok(Math.abs(keyframes[1][LEFT_KNEE] - robots[0].degrees.LEFT_KNEE_PITCH) < 0.1);
});

slow('all letters are large enough, all buttons have names, and the page needs no scroll bars', async (t) => {
  const { user } = await openMotion(t, { motion: 'wave' });

  const { small, nameless, width, height } = await user.page.evaluate(() => {
    const all = [...document.querySelectorAll('#motion-room *')].filter((each) => each.textContent.trim());
    const buttons = [...document.querySelectorAll('#motion-room button')];
    return {
      small: all.filter((each) => parseFloat(getComputedStyle(each).fontSize) < 12).length,
      nameless: buttons.filter((each) => !each.textContent.trim()).length,
      width: document.documentElement.scrollWidth,
      height: document.documentElement.scrollHeight,
    };
  });

  assert.deepEqual({ small, nameless, width, height }, { small: 0, nameless: 0, width: 1366, height: 768 });
});
