/** Saved versions of a program are listed, compared and restored, and their files never prevent a save. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { slow } from '../tests.js';
import { EDITOR, openStudio } from '../user.js';

const HISTORY = '.studio/history/Kick.java.json';
const force = (number, more = '') => `class Kick {\n    int force = ${number};\n${more}}\n`;
const onWindows = (text) => text.replaceAll('\n', '\r\n');

const openKick = (t, text, files = {}) =>
  openStudio(t, { room: 'program/Kick.java', files: { 'Kick.java': text, ...files } });

const kick = ({ folder }) => readFileSync(join(folder, 'Kick.java'), 'utf8');

/** Saves a program, whose line ends are those of Windows. */
async function saves(studio, text, saved = onWindows(text)) {
  await studio.user.writes(text);
  await studio.user.clicks('button', 'Save');
  await studio.user.until(() => kick(studio) === saved);
}

/** Opens the history, whose first version is that of the last save, and returns the list. */
async function opensHistory(user) {
  await user.clicks('button', 'History');
  return user.reads('listbox', 'Saved versions', 'just now');
}

slow('a version is compared and restored by keyboard', async (t) => {
  const studio = await openKick(t, onWindows(force(1)));
  const { user } = studio;
  await saves(studio, force(2));
  await saves(studio, force(2, '    int side = 1;\n'));
  await user.writes(force(3));

  const versions = await opensHistory(user);
  assert.equal(versions, 'just now, 2 lines differ\njust now, 1 line differs\nearlier, 1 line differs');
  await user.presses('ArrowDown', 'ArrowDown');
  const comparison = '  class Kick {\n−     int force = 1;\n+     int force = 3;\n  }\n  ';
  assert.equal(await user.reads('region', 'Comparison'), comparison);
  await user.clicks('button', 'Restore');

  await user.reads('textbox', EDITOR, 'force = 1');
  await user.until(() => kick(studio) === onWindows(force(1)));
  await user.clicks('textbox', EDITOR);
  await user.presses('Control+z');
  await user.reads('textbox', EDITOR, 'force = 3');
  assert.match(await opensHistory(user), /^just now, 1 line differs\njust now, same as now/);
});

slow('a damaged history is replaced', async (t) => {
  const studio = await openKick(t, 'class Kick {}\n', { [HISTORY]: '[{"text": 3}, nonsense' });

  await saves(studio, 'class Kick { int force; }\n', 'class Kick { int force; }\n');

  assert.equal(await opensHistory(studio.user), 'just now, same as now\nearlier, 1 line differs');
});

slow('a program is saved without place for its history', async (t) => {
  const studio = await openKick(t, 'class Kick {}\n', { [`${HISTORY}/occupied/file`]: '' });
  studio.user.expectsComplaints(/Failed to load resource: .* (409|500) /);

  await saves(studio, 'class Kick { int force; }\n', 'class Kick { int force; }\n');

  await studio.user.clicks('button', 'History');
  await studio.user.sees('Kick.java has no saved versions yet.');
});
