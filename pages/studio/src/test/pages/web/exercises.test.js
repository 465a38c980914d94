/** Exercises in the web edition: compiled and graded in the browser, with the same results as on the command line. */
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { copyFile, mkdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { solution, SOLUTIONS } from '../solutions.js';
import { folderWith, runCommand } from '../stage.js';
import { slow } from '../tests.js';
import { EDITOR, openWebEdition } from '../user.js';

const project = (path) => fileURLToPath(new URL(`../../../../../../${path}`, import.meta.url));

/** Worksheets, such as `12-kick`. */
const WORKSHEETS = readdirSync(project('docs/exercises'))
  .filter((name) => /^\d+-.*\.md$/.test(name))
  .map((name) => name.replace('.md', ''))
  .sort();
const LOCKED = project('app/src/bundle/locked.txt');

/** A host without solutions of a teacher. */
const NO_SOLUTIONS = /status of 404/;

const linesOf = (text) => text.split(/\r?\n/).filter((line) => line.trim());

/** Sets the progress of earlier days, by names of exercises. */
const hasWorkedOn = (user, exercises) =>
  user.page.evaluate((states) => {
    const key = `${new URL('.', location.href).pathname}robonewbie-page-progress`;
    localStorage.setItem(key, JSON.stringify(states));
  }, exercises);

/** Writes a program for the exercise that is open, and checks it fast. */
async function checks(user, program) {
  await user.finds('button', 'Check');
  if (program) {
    await user.writes(program);
  }
  await user.fills('combobox', 'Speed', 'fastest');
  await user.clicks('button', 'Check');
}

/** Waits for the result of so many trials, and returns its lines: points, trials and hints. */
async function result(user, trials) {
  for (let seed = 1; seed <= trials; seed++) {
    await user.reads('region', 'Output', ` Seed ${seed}: `);
  }
  const output = await user.reads('region', 'Output', /assed: \d/);
  return linesOf(output).filter((line) => /^(Passed|Not yet passed|. Seed \d|Hint): /.test(line));
}

/** Returns the lines of the result that the command line gives. */
async function resultOnTheCommandLine(t, name, file) {
  const folder = await folderWith(t, { [file]: solution(file) });
  await runCommand(folder, 'grade', name, file, '--fence', 'none', '--json', 'grade.json');
  const { passed, points, trials } = JSON.parse(await readFile(join(folder, 'grade.json'), 'utf8'));
  const hints = new Set(trials.map(({ score }) => score.hint).filter(Boolean));
  return [
    `${passed ? 'Passed' : 'Not yet passed'}: ${points.toFixed(1)} of 10 points`,
    ...trials.map(
      ({ seed, score }) => `${score.passed ? '✓' : '✗'} Seed ${seed}: ${score.points} points, ${score.finding}`,
    ),
    ...[...hints].map((hint) => `Hint: ${hint}`),
  ];
}

for (const name of WORKSHEETS.map((worksheet) => worksheet.replace(/^\d+-/, ''))) {
  slow(`the solution of ${name} earns the same in the page as on the command line`, async (t) => {
    const { user } = await openWebEdition(t, { to: `#program/${name}` });
    await user.finds('button', 'Check');
    const program = await user.finds('combobox', 'Program');
    const file = (await program.evaluate(({ value }) => value)).replace('own ', '');

    await checks(user, solution(file));

    const expected = await resultOnTheCommandLine(t, name, file);
    assert.deepEqual(await result(user, 3), expected);
  });
}

slow('the first exercise is solved in the room for programs', async (t) => {
  const folder = await folderWith(t);
  await runCommand(folder, 'grade', 'raise-arms', '--start');
  const { user, visit } = await openWebEdition(t, { to: '#program/raise-arms' });
  await user.finds('button', 'Check');
  const starter = await user.reads('textbox', EDITOR, 'RaiseArms');
  assert.deepEqual(linesOf(starter), linesOf(await readFile(join(folder, 'RaiseArms.java'), 'utf8')));

  await checks(user, solution('RaiseArms.java'));
  await user.sees('Passed: 10.0 of 10 points');
  await user.clicks('button', 'Back to the free pitch');
  await user.sees('Waiting for a robot…');
  await user.reads('region', 'Time', /cycle \d{2}/);

  await visit('#field/exercises');
  await user.finds('button', '✓ 1 Raise both arms first steps · 10.0 of 10 points · 1 try · 0 min');
  await user.sees(/1 of 26 exercises passed.*\s+First success\s+Save/);
  const { bytes } = await user.downloads(() => user.clicks('button', 'Save for my teacher'));
  const lines = linesOf(bytes.toString());
  assert.equal(lines.length, 1 + WORKSHEETS.length);
  assert.match(lines[0], /^name,exercise,passed,best points,tries,minutes,hints,solution seen,last/);
  assert.match(lines[1], /^,01-raise-arms,yes,10\.0,1,/);
});

slow('badges and the table for a teacher are those of the command line', async (t) => {
  const names = WORKSHEETS.map((worksheet) => worksheet.replace(/^\d+-/, ''));
  const statesWith = (state) => Object.fromEntries(names.map((name) => [name, { tries: 10, passed: true, ...state }]));
  const progress = { version: 1, exercises: statesWith({ bestPoints: 10, seconds: 0 }) };
  const folder = await folderWith(t, { 'progress.json': JSON.stringify(progress) });
  const shown = await runCommand(folder, 'grade', '--progress', '--csv', 'table.csv', '--name', '');
  const [, badges] = /Badges: (.*)/.exec(shown);
  const { user, visit } = await openWebEdition(t);
  await hasWorkedOn(user, statesWith({ best: 10, milliseconds: 0, hints: 0, seenAt: 0 })); // stored by an earlier version

  await visit('#field/exercises');

  await user.sees('26 of 26 exercises passed, 260.0 of 260 points');
  await user.sees(`\n${badges.replace(/ \(.*?\)(, |$)/g, '')}\n`);
  const { name, bytes } = await user.downloads(() => user.clicks('button', 'Save for my teacher'));
  assert.equal(name, 'progress.csv');
  assert.deepEqual(linesOf(bytes.toString()), linesOf(await readFile(join(folder, 'table.csv'), 'utf8')));
});

slow('the solution of a teacher is shown after three tries unless it is locked', async (t) => {
  const { user, visit, folder } = await openWebEdition(t, { to: '#field/exercises' });
  user.expectsComplaints(NO_SOLUTIONS);
  const opensTheExercise = async (progress) => {
    await visit('#field/exercises');
    await user.clicks('button', `1 Raise both arms first steps · ${progress}`);
    await user.sees('Open hint 1 of ');
  };
  await opensTheExercise('15 min');
  await user.seesNo('Solution after');

  await mkdir(join(folder, 'solutions'));
  await copyFile(join(SOLUTIONS, 'RaiseArms.java'), join(folder, 'solutions/RaiseArms.java'));
  await writeFile(join(folder, 'solutions/locked.txt'), `${await readFile(LOCKED, 'utf8')}kick\n`);
  await opensTheExercise('15 min');
  await user.finds('button', 'Solution after 3 more tries');
  const tried = { tries: 3, best: 4, passed: false, milliseconds: 0, hints: 0, seenAt: 0 };
  await hasWorkedOn(user, { 'raise-arms': tried });
  await opensTheExercise('4.0 of 10 points · 3 tries · 0 min');
  await user.clicks('button', 'Show me a solution');
  await user.sees(solution('RaiseArms.java').trim());
  await user.seesNo('package org.robonewbie');

  await writeFile(join(folder, 'solutions/locked.txt'), '1\n');
  await opensTheExercise('4.0 of 10 points · 3 tries · 0 min');
  await user.seesNo('Show me a solution');
});

slow('a starter program gets a hint', async (t) => {
  const { user } = await openWebEdition(t, { to: '#program/stop-at-30' });

  await checks(user);

  await user.sees('Not yet passed');
  await user.sees(/^Hint: \w/m);
});

slow('a result is translated to German', async (t) => {
  const folder = await folderWith(t);
  await runCommand(folder, 'grade', 'stop-at-30', '--start');
  const graded = ['grade', 'stop-at-30', 'StopAt30.java', '--fence', 'none', '--seeds', '1', '--language', 'de'];
  const said = await runCommand(folder, ...graded);
  const { user, visit } = await openWebEdition(t, { to: '#field/exercises' });
  await user.fills('combobox', 'Language of the exercises', 'de');
  await user.sees('Beide Arme heben');

  await visit('#program/stop-at-30');
  await checks(user);

  const [, finding] = /Startzahl 1 .*Punkte {2}(.*)/.exec(said);
  const [, hint] = /Hinweis: (.*)/.exec(said);
  await user.sees(`✗ Seed 1: 0 points, ${finding}`);
  await user.sees(`Hint: ${hint}`);
  await user.sees('Not yet passed');
});

slow('each exercise is listed with its worksheet', async (t) => {
  const { user } = await openWebEdition(t, { to: '#field/exercises' });
  user.expectsComplaints(NO_SOLUTIONS);
  await user.sees(`0 of ${WORKSHEETS.length} exercises passed`);

  const lessons = await user.page.$$eval('#course [data-exercise]', (all) => all.map(({ innerText }) => innerText));

  assert.equal(lessons.length, WORKSHEETS.length);
  for (const lesson of lessons) {
    await user.clicks('button', lesson.replace(/\s+/g, ' '));
    const sheet = await (await user.finds('link', 'Worksheet')).evaluate(({ href }) => href);
    assert.ok((await fetch(sheet)).ok, sheet);
    assert.ok(
      WORKSHEETS.some((name) => sheet.endsWith(`/docs/exercises/${name}.html`)),
      sheet,
    );
    await user.clicks('button', '← All exercises');
  }
});

slow('a program that does not compile is not tried', async (t) => {
  const { user } = await openWebEdition(t, { to: '#program/raise-arms' });
  await user.finds('button', 'Check');

  await user.writes('public class RaiseArms {');
  await user.clicks('button', 'Check');

  await user.sees('RaiseArms.java does not compile');
  await user.seesNo('Trial 1 of');
});
