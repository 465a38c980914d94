/** Exercises in the web edition: compiled and judged in the browser, with the same results as on the command line. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { copyFile, mkdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { solution, SOLUTIONS } from '../solutions.js';
import { folderWith } from '../stage.js';
import { quick, slow } from '../tests.js';
import { openWebEdition } from '../user.js';

const project = (path) => fileURLToPath(new URL(`../../../../../../${path}`, import.meta.url));

const LOCKED = project('app/src/bundle/locked.txt');
const ROBONEWBIE = project('app/target/robonewbie.jar'); // after ./mvnw package
const BADGES = [
  ...['First success', 'First steps', 'Basics', 'Advanced', 'Challenger', 'Perfectionist', 'Own way', 'Persistent'],
  'The whole course',
];

/** A plain host answers so for a course without solutions of a teacher. */
const NO_SOLUTIONS = /status of 404/;

/** Returns all exercises, with `name` and `file`. */
const exercises = (user) => user.page.evaluate(async () => (await (await fetch('api/course')).json()).lessons);

/** Sets the progress that was made on earlier days. */
const hasWorkedOn = (user, ...progress) =>
  user.page.evaluate((entries) => {
    const key = `${new URL('.', location.href).pathname}robonewbie-page-progress`;
    const states = entries.map(([name, state]) => [name, { milliseconds: 0, hints: 0, seenAt: 0, ...state }]);
    localStorage.setItem(key, JSON.stringify(Object.fromEntries(states)));
  }, progress);

async function checks(user) {
  await user.fills('combobox', 'Speed', 'fastest');
  await user.clicks('button', 'Check');
}

for (const file of readdirSync(SOLUTIONS).filter((name) => /^[A-Z]/.test(name))) {
  slow(`${file} earns the same in the page as on the command line`, async (t) => {
    const { user, visit } = await openWebEdition(t, { to: '#program' });
    const { name } = (await exercises(user)).find((exercise) => exercise.file === file);
    await visit(`#program/${name}`);

    await user.writes(solution(file));
    await checks(user);

    for (const { seed, score } of await gradeOnTheCommandLine(t, name, file)) {
      await user.sees(`Seed ${seed}: `);
      await user.sees(`${score.passed ? '✓' : '✗'} Seed ${seed}: ${score.points} points, ${score.finding}`);
      await user.sees(score.hint);
    }
  });
}

/** Returns the trials, each with seed and score `{passed, points, finding, hint}`. */
async function gradeOnTheCommandLine(t, name, file) {
  const folder = await folderWith(t, { [file]: solution(file) });
  const env = { ...process.env, ROBONEWBIE_PROGRESS: 'off' };
  const command = ['-jar', ROBONEWBIE, 'grade', name, file, '--fence', 'none', '--json', 'grade.json'];
  execFileSync('java', command, { cwd: folder, env, stdio: 'ignore' });
  return JSON.parse(await readFile(join(folder, 'grade.json'), 'utf8')).trials;
}

quick('each exercise has a worksheet, and a solution to be checked', async (t) => {
  const { user } = await openWebEdition(t, { to: '#field/exercises' });

  await user.sees(/0 of \d+ exercises passed/);
  const all = await exercises(user);

  for (const { number, title, file, worksheet } of all) {
    assert.match(await user.text(), new RegExp(`\n${number} ${title.replaceAll('?', '\\?')}\n`));
    assert.ok(readdirSync(SOLUTIONS).includes(file), file);
    assert.ok(await user.page.evaluate(async (sheet) => (await fetch(sheet)).ok, worksheet), worksheet);
  }
});

quick('the first exercise is solved in the room for programs', async (t) => {
  const { user, visit } = await openWebEdition(t, { to: '#program/raise-arms' });
  await user.sees('left < 30 ? 60 : 0');

  await user.writes(solution('RaiseArms.java'));
  await checks(user);
  await user.sees('Passed: 10.0 of 10 points');
  await user.clicks('button', 'Back to the free pitch');
  await user.sees('Waiting for a robot…');

  await visit('#field/exercises');
  await user.sees(/1 of 26 exercises passed.*\s+First success\s+Save/);
  const { bytes } = await user.downloads(() => user.clicks('button', 'Save for my teacher'));
  const lines = bytes.toString().trim().split(/\r?\n/);
  assert.equal(lines.length, 1 + 26);
  assert.match(lines[0], /^name,exercise,passed,best points,tries,minutes,hints,solution seen,last/);
  assert.match(lines[1], /^,01-raise-arms,yes,10\.0,1,/);
});

quick('who has passed everything has all badges', async (t) => {
  const { user, visit } = await openWebEdition(t);
  const all = (await exercises(user)).map(({ name }) => [name, { tries: 10, best: 10, passed: true }]);
  await hasWorkedOn(user, ...all);

  await visit('#field/exercises');

  await user.sees(`${BADGES.join('')}\n`);
});

quick('the solution of a teacher is shown after three tries unless it is locked', async (t) => {
  const { user, visit, folder } = await openWebEdition(t, { to: '#field/exercises' });
  user.expectsComplaints(NO_SOLUTIONS);
  const opensTheExercise = async (name) => {
    await visit('#field/exercises');
    await user.clicks('button', name);
    await user.sees('Open hint 1 of ');
  };
  await opensTheExercise('1 Raise both arms first steps · 15 min');
  await user.seesNo('Solution after');

  await mkdir(join(folder, 'solutions'));
  await copyFile(join(SOLUTIONS, 'RaiseArms.java'), join(folder, 'solutions/RaiseArms.java'));
  await writeFile(join(folder, 'solutions/locked.txt'), `${await readFile(LOCKED, 'utf8')}kick\n`);
  await opensTheExercise('1 Raise both arms first steps · 15 min');
  await user.sees('Solution after 3 more tries');
  await hasWorkedOn(user, ['raise-arms', { tries: 3, best: 4, passed: false }]);
  await opensTheExercise('1 Raise both arms first steps · 4.0 of 10 points · 3 tries · 0 min');
  await user.clicks('button', 'Show me a solution');
  await user.sees(solution('RaiseArms.java').trim().slice(0, 20));

  await writeFile(join(folder, 'solutions/locked.txt'), '1\n');
  await opensTheExercise('1 Raise both arms first steps · 4.0 of 10 points · 3 tries · 0 min');
  await user.seesNo('Show me a solution');
});

quick('a starter program gets a hint', async (t) => {
  const { user } = await openWebEdition(t, { to: '#program/stop-at-30' });

  await checks(user);

  await user.sees('Not yet passed');
  await user.sees('Hint: When the sensor reads 30, two more steps are under way');
});

quick('a verdict is in German for who reads German', async (t) => {
  const { user, visit } = await openWebEdition(t, { to: '#field/exercises' });
  await user.fills('combobox', 'Language of the exercises', 'de');
  await user.sees('Beide Arme heben');

  await visit('#program/stop-at-30');
  await checks(user);

  await user.sees(/Seed 1: 0 points, höchster Winkel \d/);
  await user.sees('Wenn der Sensor 30 sagt, sind noch zwei Schritte unterwegs');
});

quick('a program that does not compile is not tried', async (t) => {
  const { user } = await openWebEdition(t, { to: '#program/raise-arms' });

  await user.writes('public class RaiseArms {');
  await user.clicks('button', 'Check');

  await user.sees('RaiseArms.java does not compile');
});
