/** Work in the Motion room is never lost, undo takes back what is visible, and each problem has its message. */
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { slow } from '../tests.js';
import {
  answers,
  fileOf,
  keepsADraft,
  openMotion,
  pointOfLimb,
  readsAngle,
  seesKeyframes,
  STANDING,
  takesBack,
  turns,
  types,
} from './motion-room.js';

const ONE_KEYFRAME = `500 ${STANDING}\n`;
const LIMIT = /^The left .* is at its limit\.$/m;
const NECK_YAW = 'neck yaw in degrees';
const TIME = 'Time to reach this keyframe in milliseconds';

const openMine = (t, options = {}) => openMotion(t, { files: { mine: ONE_KEYFRAME }, ...options });

slow('a new motion leaves the unnamed one before it in the list', async (t) => {
  const studio = await openMine(t);
  const { user } = studio;

  await user.clicks('button', '+ New');
  await turns(user, 'neck yaw', '44');
  await user.clicks('button', '+ New');
  await readsAngle(user, 'neck yaw', '0');
  await turns(user, 'neck yaw', '-20');
  const second = await keepsADraft(studio, 'new motion 2');
  await user.clicks('button', 'new motion 1 •');

  await readsAngle(user, 'neck yaw', '44');
  assert.match(await readFile(await keepsADraft(studio, 'new motion 1'), 'utf8'), /^500 44/);
  assert.match(await readFile(second, 'utf8'), /^500 -20/);
});

slow('a change made while another motion is being opened stays with the motion that is left', async (t) => {
  const files = { mine: ONE_KEYFRAME, other: ONE_KEYFRAME };
  const { user } = await openMotion(t, { files, before: holdBackTheOther });
  await user.clicks('button', 'other');
  await user.page.waitForFunction(() => window.answer);

  await turns(user, 'neck yaw', '44');
  await user.page.evaluate(() => window.answer());

  await readsAngle(user, 'neck yaw', '0');
  await user.clicks('button', 'mine •');
  await readsAngle(user, 'neck yaw', '44');
});

/** Keeps back the content of the motion `other` once, until the function `answer` is called. */
function holdBackTheOther() {
  const ask = window.fetch;
  window.fetch = async (...request) => {
    if (!window.answer && /files\/motion\/other$/.test(String(request[0]))) {
      await new Promise((answer) => Object.assign(window, { answer }));
    }
    return ask(...request);
  };
}

slow('an unnamed motion is saved under a name and its draft goes', async (t) => {
  const studio = await openMine(t);
  const { user } = studio;
  await user.clicks('button', '+ New');
  await turns(user, 'neck yaw', '44');
  const draft = await keepsADraft(studio, 'new motion 1');

  await user.clicks('button', 'Save');
  await answers(user, 'look');

  await user.finds('button', 'look');
  await user.until(() => !existsSync(draft));
  assert.match(await fileOf(studio, 'look'), /^500 44/);
});

slow('arrow keys continue from typed angles', async (t) => {
  const { user } = await openMine(t);

  await types(user, NECK_YAW, '12,5');
  await user.presses('ArrowUp');
  await readsAngle(user, 'neck yaw', '13.5');

  await types(user, NECK_YAW, '1e9');
  await user.presses('ArrowUp');
  await user.sees('“1e9” is not an angle');
  await readsAngle(user, 'neck yaw', '13.5');
});

slow('huge numbers of a file are drawn with few lines', async (t) => {
  const huge = `999999999 1e9${STANDING.slice(1)}\n`;
  const { user } = await openMotion(t, { motion: 'huge', files: { huge } });

  await user.clicks('button', 'Curves');

  await user.page.waitForSelector('.track-drawing .tick-text');
  const ticks = (await user.page.$$('#motion-timeline .tick-text')).length;
  assert.ok(ticks >= 3 && ticks <= 40, `${ticks} ticks`);
});

slow('a typed angle is in the file that is saved by a key', async (t) => {
  const studio = await openMine(t);

  await types(studio.user, NECK_YAW, '17');
  await studio.user.presses('Control+s');

  await studio.user.sees('Saved.');
  assert.match(await fileOf(studio), /^500 17/);
});

slow('a typed time is played', async (t) => {
  const { user } = await openMine(t);

  await types(user, TIME, '900');
  await user.clicks('button', '▶ Play');

  await seesKeyframes(user, 900);
});

slow('undo in the field takes back the angle, which was one change, and shows the old one', async (t) => {
  const { user } = await openMine(t);
  await types(user, NECK_YAW, '35');
  await user.presses('Enter', 'Control+z');
  await readsAngle(user, 'neck yaw', '0');
  await takesBack(user, 0);

  await (await user.finds('textbox', NECK_YAW)).focus();
  await user.presses('Control+y');

  await readsAngle(user, 'neck yaw', '35');
});

slow('an angle that is entered and left is one change', async (t) => {
  const { user } = await openMine(t);

  await turns(user, 'neck yaw', '21');
  await user.presses('Tab');

  await readsAngle(user, 'neck yaw', '21');
  await takesBack(user, 1);
});

slow('Caps Lock changes no order', async (t) => {
  const { user } = await openMine(t);
  await turns(user, 'neck yaw', '35');
  await user.finds('button', 'mine •');

  await user.presses('Control+Z');

  await readsAngle(user, 'neck yaw', '0');
});

slow('a word in a number field is refused with a message', async (t) => {
  const { user } = await openMine(t);

  await turns(user, 'neck yaw', 'abc');

  await user.sees('“abc” is not an angle in degrees: neck yaw stays as it is.');
  await readsAngle(user, 'neck yaw', '0');
});

slow('a line that cannot be read is reported', async (t) => {
  const { user } = await openMine(t, {
    files: { mine: ONE_KEYFRAME, broken: `${ONE_KEYFRAME}this line is nonsense\n` },
  });

  await user.clicks('button', 'broken');

  await user.sees(/^Line 2 cannot be read/m);
});

slow('a file that hides a motion of the library shows a warning', async (t) => {
  const { user } = await openMine(t, { motion: 'wave', files: { wave: ONE_KEYFRAME } });
  await turns(user, 'neck yaw', '44');

  await user.clicks('button', 'Save');

  await user.sees('it replaces the library motion with that name.');
});

slow('the note after saving covers no keyframe', async (t) => {
  const { user } = await openMine(t);
  await turns(user, 'neck yaw', '44');
  await user.clicks('button', 'Save');
  await user.sees('Saved.');

  const note = await (await user.page.$('#toast')).boundingBox();
  const play = await (await user.finds('button', '▶ Play')).boundingBox();

  assert.ok(note.y + note.height < play.y);
});

slow('the list of motions keeps its buttons when another file appears', async (t) => {
  const { user, folder } = await openMine(t);
  const mine = await user.finds('button', 'mine');
  await mine.focus();

  await writeFile(join(folder, 'another.txt'), ONE_KEYFRAME);

  await user.finds('button', 'another');
  assert.ok(await mine.evaluate((button) => button === document.activeElement));
});

slow('the last time of the ruler is read in whole', async (t) => {
  const { user } = await openMine(t);
  await seesKeyframes(user, 500);

  const ends = await user.page.$$eval('.tick-text', (all) => all.map((tick) => tick.getBoundingClientRect().right));

  assert.ok(ends.length > 1);
  assert.ok(Math.max(...ends) <= 1366);
});

slow('the words of the verdict are explained', async (t) => {
  const { user } = await openMine(t);

  await user.until(async () => /centre of mass/.test(await user.page.$eval('.verdict', ({ title }) => title)));
});

slow('a limb that cannot follow the mouse says which joint is at its limit', async (t) => {
  const { user } = await openMine(t);
  const { mouse } = user.page;
  const [x, y] = await pointOfLimb(user, 'llowerarm');
  await mouse.move(x, y);
  await mouse.down();

  let turn = 0;
  await user.until(async () => {
    turn += Math.PI / 6;
    await mouse.move(x + 170 * Math.cos(turn), y + 170 * Math.sin(turn));
    return LIMIT.test(await user.text());
  });
  await mouse.up();

  await user.seesNo(LIMIT);
});

slow('a robot that is lifted has no feet on the ground, which is no mistake', async (t) => {
  const { user } = await openMine(t);
  const [x, y] = await pointOfLimb(user, 'body');
  await user.page.mouse.move(x, y);
  await user.page.mouse.down();

  await user.page.mouse.move(x, y - 240, { steps: 6 });

  await user.until(() => user.page.evaluate(() => !studio.motion.stage.marker.support.visible));
  await user.page.mouse.up();
  await user.sees('mine •');
});

slow('a lost simulator is reported, and unsaved work keeps the page from closing', async (t) => {
  const { user, stage } = await openMine(t);
  user.expectsComplaints(/ERR_CONNECTION_REFUSED|WebSocket/);
  await stage.close();
  await user.sees('The simulator has ended.');

  await turns(user, 'neck yaw', '44');

  await user.sees('The draft could not be saved');
  assert.ok(await user.isAskedBeforeClosing());
});

slow('the page closes without a question if all work is kept', async (t) => {
  const studio = await openMine(t);
  await turns(studio.user, 'neck yaw', '44');
  await keepsADraft(studio);

  await studio.user.until(async () => !(await studio.user.isAskedBeforeClosing()));
});
