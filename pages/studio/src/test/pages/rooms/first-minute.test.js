/** A newcomer opens the studio for the first time and passes three levels. */
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { findsNoBarrier } from '../accessibility.js';
import { slow } from '../tests.js';
import { EDITOR, FOR_PICTURES, openStudio } from '../user.js';

const LEVELS = ['Make the robot wave', 'Make it look at the ball', 'Make it walk to the ball and kick'];
const [WAVE, LOOK] = LEVELS;

const openAsNewcomer = (t, options = {}) => openStudio(t, { room: '', isNewcomer: true, ...options });

/** Inserts all lines that the editor proposes by the Tab key. */
async function insertsProposals(user, level, then = 'Press ▶ Run') {
  while (!(await user.reads('region', level)).includes(then)) {
    await user.presses('Tab');
  }
}

async function passes(user, level) {
  await insertsProposals(user, level);
  await user.presses('Control+Enter');
  await user.reads('region', level, 'Well done: ');
}

/** Sees the field, without being led to the Program room. */
async function seesTheField(user) {
  await user.finds('link', 'Program');
  assert.equal(new URL(user.page.url()).hash, '');
}

const robotsAre = ({ user, stage }, number) => user.until(async () => (await stage.world()).robots.length === number);

slow('three levels lead to the first exercise by keyboard alone', async (t) => {
  const studio = await openAsNewcomer(t);
  const { user, visit, folder } = studio;
  await robotsAre(studio, 1);

  for (const level of LEVELS) {
    await passes(user, level);
    await user.presses('Enter');
  }

  await user.finds('button', 'Check');
  await user.findsNo('region', LEVELS[2]);
  await user.readsValue('combobox', 'Program', 'own RaiseArms.java');
  await robotsAre(studio, 0);
  assert.match(readFileSync(join(folder, 'Wave.java'), 'utf8'), /LEFT_SHOULDER_PITCH, 90/);
  await visit();
  await seesTheField(user);
});

slow('a level that is not passed says what to do', async (t) => {
  const { user } = await openAsNewcomer(t);
  await user.finds('region', WAVE);

  await user.clicks('button', '▶ Run');

  await user.reads('region', WAVE, 'Not yet: the hand stayed');
  await user.reads('region', WAVE, 'A larger angle raises the arm higher.');
  await user.findsNo('button', 'Next level');
});

slow('a mistake found by the compiler is fixed first', async (t) => {
  const { user } = await openAsNewcomer(t);
  await user.finds('region', WAVE);

  await user.types('x'); // replaces the selected angle

  await user.reads('textbox', EDITOR, 'LEFT_SHOULDER_PITCH, x)');
  await user.clicks('button', '▶ Run');
  await user.reads('region', WAVE, 'Fix the line marked in red first.');
});

slow('skipped levels never return', async (t) => {
  const studio = await openAsNewcomer(t);
  const { user, visit, folder } = studio;
  await user.finds('region', WAVE);

  await user.clicks('button', 'Skip');

  await user.readsValue('combobox', 'Program', 'own MyAgent.java');
  await robotsAre(studio, 0);
  await visit();
  await seesTheField(user);
  assert.equal(existsSync(join(folder, 'Wave.java')), false);
});

slow('a reloaded page continues with the same level and text', async (t) => {
  const { user, visit, folder } = await openAsNewcomer(t);
  const draft = join(folder, '.studio/programs/Wave.java');
  await insertsProposals(user, WAVE);
  await user.until(() => existsSync(draft) && readFileSync(draft, 'utf8').includes('LEFT_SHOULDER_PITCH, 90'));

  await visit();

  await user.reads('region', WAVE, 'Press ▶ Run');
  await passes(user, WAVE);
  await visit();
  await user.finds('region', LOOK);
});

slow('the levels speak German', async (t) => {
  const { user } = await openAsNewcomer(t);
  await user.finds('region', WAVE);

  await user.clicks('button', 'Deutsch');

  const level = await user.finds('region', 'Lass den Roboter winken');
  assert.equal(await level.evaluate((section) => section.lang), 'de');
  await insertsProposals(user, 'Lass den Roboter winken', 'Drücke ▶ Run');
});

slow('a returning user sees the field first', async (t) => {
  const { user } = await openAsNewcomer(t, { files: { 'MyAgent.java': 'public class MyAgent {}' } });

  await seesTheField(user);

  await user.clicks('link', 'Program');
  await user.readsValue('combobox', 'Program', 'own MyAgent.java');
  await user.findsNo('region', WAVE);
});

for (const [theme, width] of [
  ['light', 1366],
  ['dark', 1024],
]) {
  slow(`the ${theme} levels are accessible and worth a picture at ${width} pixels`, async (t) => {
    const { user } = await openAsNewcomer(t, { theme, width, ...FOR_PICTURES });
    const takesAPicture = (name) => user.takesAPicture(`first-minute-${theme}-${width}-${name}`);

    for (const [i, level] of LEVELS.entries()) {
      await user.reads('region', level, ` ${i + 1} / 3`);
      await takesAPicture(`${i + 1}-start`);
      await findsNoBarrier(user, level);
      await insertsProposals(user, level);
      await takesAPicture(`${i + 1}-run`);
      await user.clicks('button', '▶ Run');
      await takesAPicture(`${i + 1}-watch`);
      await user.reads('region', level, 'Well done: ');
      await takesAPicture(`${i + 1}-passed`);
      await findsNoBarrier(user, level);
      await user.clicks('button', i < 2 ? 'Next level' : 'Go on with exercise 1');
    }
    await user.finds('button', 'Check');
    await takesAPicture('4-exercise');
  });
}
