/** A student follows the guide to the first motion literally. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { folderWith, startCommand } from '../stage.js';
import { picture } from '../tests.js';
import { FOR_PICTURES, newUser, openStudio } from '../user.js';
import { answers, fileOf, keyframesIn, pointOfLimb, seesKeyframes, turns } from './motion-room.js';

const GUIDE = readFileSync(new URL('../../../../../../docs/first-motion.md', import.meta.url), 'utf8');
const EMPTY = '// still empty\n';
const NAME = 'my-first';

/** Returns the bold words of the numbered steps: what is chosen or pressed. */
function boldWords() {
  const steps = GUIDE.match(/^\d\. [^]*?(?=^## )/m)[0];
  return [...steps.matchAll(/\*\*(.+?)\*\*/g)].map(([, words]) => words);
}

/** Drags the left arm. */
async function dragsTheArm(user) {
  const pitch = await user.finds('textbox', 'left shoulder pitch in degrees');
  const before = await pitch.evaluate((field) => field.value);
  const [x, y] = await pointOfLimb(user, 'lupperarm');
  await user.drags([x, y], [x + 30, y - 60]);
  await user.until(async () => (await pitch.evaluate((field) => field.value)) !== before);
}

/** Sets the angles of the left shoulder. */
async function turnsTheArm(user, pitch, yaw) {
  await turns(user, 'left shoulder pitch', pitch);
  await turns(user, 'left shoulder yaw', yaw);
}

picture('the guide leads to a motion of three keyframes that an agent plays by its name', async (t) => {
  const [motion, create, keyframe, play, tryIt, save, ...others] = boldWords();
  assert.deepEqual(others, []);
  const studio = await openStudio(t, { files: { 'my-dance.txt': EMPTY, 'my-kick.txt': EMPTY }, ...FOR_PICTURES });
  const { user } = studio;

  await user.clicks('link', motion);
  await user.clicks('button', create);
  await seesKeyframes(user, 500);
  await dragsTheArm(user);
  await turnsTheArm(user, '-95', '60');
  await user.takesAPicture('first-motion-1');
  for (const yaw of ['20', '70']) {
    await user.clicks('button', keyframe);
    await turnsTheArm(user, '60', yaw);
  }
  await seesKeyframes(user, 500, 1000, 1500);
  await (await user.finds('image', 'Keyframe 2 at 1.00 s')).click();
  await user.sees('1.00 s of 1.50 s');
  await user.takesAPicture('first-motion-2');
  await user.clicks('button', play);
  await user.sees('1.50 s of 1.50 s');
  await user.finds('button', play);
  await user.clicks('button', tryIt);
  await user.sees('The robot stays on its feet.');
  await (await user.finds('image', 'Keyframe 3 at 1.50 s')).click();
  await user.clicks('checkbox', 'With physics');
  await user.sees('Trial with physics');
  await user.seesNo('The robot stays on its feet.');
  await user.takesAPicture('first-motion-3');
  await user.clicks('button', save);
  await answers(user, NAME);
  await user.finds('button', NAME);

  assert.equal(keyframesIn(await fileOf(studio, NAME)).length, 3);
  await playsIt(t, await fileOf(studio, NAME));
});

/** Starts the agent of the guide, and waits until its arm is where the last keyframe has it. */
async function playsIt(t, text) {
  const folder = await folderWith(t, { [`motions/${NAME}.txt`]: text });
  const address = await startCommand(t, folder, 'run', 'Agent_KeyframeDeveloper', NAME, '--seed', '1');
  const user = await newUser(t);
  await user.visits(`${address}&quality=lowest#robot`);
  await user.reads('region', 'Left arm', /Shoulder pitch\s+(59|60)\.\d°\s[^]*Shoulder yaw\s+(69|70)\.\d°/);
}
