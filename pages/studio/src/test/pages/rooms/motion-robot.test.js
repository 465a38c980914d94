/** The motion editor shapes motions of robots other than the NAO, which name their robot. */
import assert from 'node:assert/strict';
import { quick, slow } from '../tests.js';
import { answers, fileOf, openMotion, pointOfLimb, readsAngle, seesKeyframes, STANDING, turns } from './motion-room.js';

const KNEES = [15, 21]; // the first number of a line is the time
const T1_JOINTS = 23;
const T1 = `// robot: T1\n// bows\n500${' 0'.repeat(T1_JOINTS)}\n`;
const NAO = `500 ${STANDING}\n`;
const FOR_THE_NAO = ['Mirror', 'Mirror all', 'Balance', 'Try with physics', 'L→R', 'Save this posture…'];

/** Returns which of the buttons for the NAO the page shows or has in a menu. */
const buttonsForTheNao = ({ page }) =>
  page.$$eval(
    'button',
    (buttons, names) => {
      const shown = buttons.filter((button) => !button.hidden).map((button) => button.textContent ?? '');
      return names.filter((name) => shown.includes(name));
    },
    FOR_THE_NAO,
  );

/** Changes the motion and saves it. */
async function turnsHeadAndSaves(studio, name) {
  const { user } = studio;
  await turns(user, 'head yaw', '30');
  await user.sees(`${name} •`);
  await user.clicks('button', 'Save');
  await user.seesNo(`${name} •`);
  return fileOf(studio, name);
}

quick('a motion of a T1 is shown, changed and saved', async (t) => {
  const studio = await openMotion(t, { files: { mine: T1 }, isSharp: true, width: 1200, height: 800 });
  const { user } = studio;

  await seesKeyframes(user, 500);
  await user.sees('Waist');
  const [x, y] = await pointOfLimb(user, 'H2');
  const [head, beside] = await Promise.all([user.coloursAround([x, y], 1), user.coloursAround([x + 150, y], 1)]);
  await user.takesAPicture('motion-t1');
  const saved = await turnsHeadAndSaves(studio, 'mine');

  assert.notDeepEqual(head, beside);
  assert.deepEqual(await buttonsForTheNao(user), []);
  assert.equal(saved, T1.replace('500 0', '500 30'));
});

slow('a new motion is for the robot of the open one, and begins with its stance', async (t) => {
  const studio = await openMotion(t, { files: { mine: T1 } });
  const { user } = studio;
  await seesKeyframes(user, 500);
  await user.clicks('button', '+ New');
  await readsAngle(user, 'left knee pitch', '40');
  await user.clicks('button', 'Save');
  await answers(user, 'stands');
  await user.sees('Saved.');

  const [head, line] = (await fileOf(studio, 'stands')).split('\n');

  assert.equal(head, '// robot: T1');
  assert.equal(line.split(' ').length, 1 + T1_JOINTS);
  assert.deepEqual(
    KNEES.map((at) => line.split(' ')[at]),
    ['40', '40'],
  );
});

slow('the room changes between robots', async (t) => {
  const { user } = await openMotion(t, { files: { mine: NAO, bow: T1 } });
  await readsAngle(user, 'left arm roll', '0');
  assert.deepEqual(await buttonsForTheNao(user), FOR_THE_NAO);

  await user.clicks('button', 'bow');
  await readsAngle(user, 'waist', '0');
  await user.clicks('button', 'mine');

  await readsAngle(user, 'left arm roll', '0');
  assert.deepEqual(await buttonsForTheNao(user), FOR_THE_NAO);
});

slow('a limb of a T1 is dragged by its joint', async (t) => {
  const studio = await openMotion(t, { files: { mine: T1 } });
  const { user } = studio;
  await seesKeyframes(user, 500);
  const [x, y] = await pointOfLimb(user, 'left_hand_link');

  await user.drags([x, y], [x, y - 60]);
  await user.sees('mine •');
  await user.clicks('button', 'Save');
  await user.seesNo('mine •');

  assert.notEqual(await fileOf(studio), T1);
});

slow('a motion of an unknown robot is refused and stays', async (t) => {
  const text = '// robot: TinMan\n500 0 0 0 0 0\n';
  const studio = await openMotion(t, { motion: 'odd', files: { odd: text } });

  studio.user.expectsComplaints(/404/);
  await studio.user.sees(
    'odd.txt cannot be opened: Its robot is "TinMan", but the studio knows NAO, T1, K1 only. The file was not changed.',
  );
  assert.equal(await fileOf(studio, 'odd'), text);
});
