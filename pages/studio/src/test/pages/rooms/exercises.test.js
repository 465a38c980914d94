/** A student selects an exercise, runs a program, and sees the result. */
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { picture, quick, slow } from '../tests.js';
import { FOR_PICTURES, openStudio } from '../user.js';

const ARMS = '1 Raise both arms first steps · 15 min';
const KICK = '12 A kick of your own challenge · 120 min';
const SOLUTION = 'public class RaiseArms extends Agent {}';

/** A program that raises only one arm. */
const ONE_ARM = `import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

public class Other extends Agent {
    public static void main(String[] args) {
        new Other().run(args);
    }

    public Other() {
        System.out.println("hello from the program");
    }

    @Override
    protected void think() {
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH) < 60 ? 30 : 0);
    }
}
`;

const progressWith = (state) => JSON.stringify({ version: 1, exercises: { 'raise-arms': state } });

const openExercises = (t, { files = {}, ...options } = {}) =>
  openStudio(t, { room: 'field/exercises', files: { 'Other.java': ONE_ARM, ...files }, ...options });

async function choosesArms(user, name = ARMS) {
  await user.clicks('button', name);
  await user.finds('combobox', 'Program to run');
}

/** Lets the program try the exercise once, and waits until it is graded. */
async function tries(user) {
  await user.fills('combobox', 'Program to run', 'Other.java');
  await user.fills('combobox', 'Trials', '1');
  await user.clicks('button', 'Start');
  await user.sees('Trial 1 of 1 is running and being graded.');
  await user.sees('✗ Seed 1: 5 points, left arm');
}

const worksheet = async (user) => (await user.finds('link', 'Worksheet')).evaluate((link) => link.getAttribute('href'));
const robots = (user) => user.page.evaluate(() => studio.state.scene.robots.length);
const seesAGhost = (user) => user.page.evaluate(() => studio.field.ghosts.group.visible);

quick('a trial is shown live and its verdict beside it', async (t) => {
  const { user } = await openExercises(t);
  await choosesArms(user);

  await tries(user);

  await user.sees('Hint: Set a separate speed for each shoulder');
  await user.sees('Not yet passed: 5.0 of 10 points');
  await user.clicks('DisclosureTriangle', 'Program output');
  await user.sees('hello from the program');
  assert.equal(await robots(user), 1);
  await user.clicks('button', 'Back to the free pitch');
  await user.findsNo('button', 'Back to the free pitch');
  await user.until(async () => (await robots(user)) === 0);
});

slow('the list shows titles, levels and what was passed', async (t) => {
  const passed = { tries: 2, bestPoints: 8.5, passed: true, seconds: 420 };
  const { user } = await openExercises(t, { files: { 'progress.json': progressWith(passed) } });

  await user.finds('button', '✓ 1 Raise both arms first steps · 8.5 of 10 points · 2 tries · 7 min');
  await user.sees('1 of 26 exercises passed, 8.5 of 260 points, 7 min');
  await user.sees('First success');
  await user.clicks('button', KICK);
  assert.equal(await worksheet(user), 'docs/exercises/12-kick.html');
});

slow('hints open one after the other', async (t) => {
  const { user } = await openExercises(t);
  await choosesArms(user);

  await user.clicks('button', 'Open hint 1 of 3');
  await user.sees('reads a sensor in degrees');
  await user.clicks('button', 'Open hint 2 of 3');
  await user.clicks('button', 'Open hint 3 of 3');

  await user.sees('A fast arm overshoots.');
  await user.findsNo('button', 'Open hint 3 of 3');
});

slow('a solution is shown after three tries', async (t) => {
  const after = (count) => progressWith({ tries: count, bestPoints: 0, passed: false, seconds: 60 });
  const files = { 'progress.json': after(2), 'solutions/RaiseArms.java': SOLUTION };
  const { user, folder, visit } = await openExercises(t, { files });
  await choosesArms(user, '1 Raise both arms first steps · 0.0 of 10 points · 2 tries · 1 min');
  const locked = await user.finds('button', 'Solution after one more try');
  assert.ok(await locked.evaluate((button) => button.disabled));

  writeFileSync(join(folder, 'progress.json'), after(3));
  await visit();
  await choosesArms(user, '1 Raise both arms first steps · 0.0 of 10 points · 3 tries · 1 min');
  await user.clicks('button', 'Show me a solution');

  await user.sees(SOLUTION);
});

slow('the starter code is written and selected', async (t) => {
  const { user, folder } = await openExercises(t);
  await choosesArms(user);

  await user.clicks('button', 'Create RaiseArms.java');

  await user.readsValue('combobox', 'Program to run', 'RaiseArms.java');
  await user.findsNo('button', 'Create RaiseArms.java');
  assert.match(readFileSync(join(folder, 'RaiseArms.java'), 'utf8'), /class RaiseArms/);
});

slow('the last trial is a ghost beside the next one', async (t) => {
  const { user } = await openExercises(t);
  await choosesArms(user);
  await tries(user);
  await user.until(async () => !(await seesAGhost(user)));

  await user.clicks('button', 'Start');

  await user.until(() => seesAGhost(user));
  assert.equal(await user.page.evaluate(() => studio.field.ghosts.robots.scene.robots.length), 1);
  await user.clicks('checkbox', 'Ghost of my last trial');
  await user.until(async () => !(await seesAGhost(user)));
});

slow('exercises are translated to German', async (t) => {
  const { user } = await openExercises(t);
  await choosesArms(user);

  await user.fills('combobox', 'Language of the exercises', 'de');

  await user.finds('heading', '1 Beide Arme heben');
  await user.until(async () => (await worksheet(user)) === 'docs/exercises/de/01-raise-arms.html');
});

picture('the exercises are shown beside a trial', async (t) => {
  const { user } = await openExercises(t, FOR_PICTURES);
  await choosesArms(user);
  await tries(user);
  await user.finds('DisclosureTriangle', 'Program output');

  await user.takesAPicture('studio-exercises');
});
