/** A student finds, keeps, renames and deletes recordings, and bookmarks a moment of one. */
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { slow } from '../tests.js';
import { openStudio } from '../user.js';

const GAME = 'Ada 00:04 · 1 robot · 1 goal · 1 fall Agent_Wave game';
const FILES = {
  'game.about': JSON.stringify({ agent: 'Agent_Wave', project: 'elsewhere', starred: false, bookmarks: [] }),
  'game.notes': '{"seconds":1,"robot":"A 1","level":"INFO","text":"hm"}\n',
};

async function openRecordings(t) {
  const studio = await openStudio(t, {
    room: 'replay',
    robots: [{}],
    recordings: ['game', 'project/mine'],
    files: FILES,
  });
  await studio.user.finds('button', GAME);
  return studio;
}

const about = async (folder, name) => JSON.parse(await readFile(join(folder, `${name}.about`), 'utf8'));

slow('a card shows the agent, and the filter selects the recordings of the project', async (t) => {
  const { user } = await openRecordings(t);
  await user.reads('article', 'game', 'Agent_Wave');

  await user.fills('combobox', 'Filter recordings', 'project');

  await user.findsNo('article', 'game');
  await user.finds('article', 'mine');
});

slow('a star is kept beside the recording, and the filter selects recordings with a star', async (t) => {
  const { user, folder } = await openRecordings(t);

  await user.clicks('button', 'Star of game');
  await user.reads('button', 'Star of game', '★');
  await user.fills('combobox', 'Filter recordings', 'starred');

  await user.findsNo('article', 'mine');
  await user.finds('article', 'game');
  const { starred, agent } = await about(folder, 'game');
  assert.deepEqual({ starred, agent }, { starred: true, agent: 'Agent_Wave' });
});

slow('a recording is renamed with all that lies beside it', async (t) => {
  const { user, folder } = await openRecordings(t);

  await user.clicks('button', 'Rename game');
  await user.fills('textbox', 'New name', 'our first goal');
  await user.presses('Enter');

  await user.reads('article', 'our first goal', '1 goal');
  assert.ok(existsSync(join(folder, 'our first goal.rec')));
  assert.ok(existsSync(join(folder, 'our first goal.notes')));
  assert.equal((await about(folder, 'our first goal')).agent, 'Agent_Wave');
  assert.ok(!existsSync(join(folder, 'game.rec')));
});

slow('a deleted recording is restored by Undo', async (t) => {
  const { user, folder } = await openRecordings(t);
  const before = await readFile(join(folder, 'game.rec'));

  await user.clicks('button', 'Delete game');
  await user.findsNo('article', 'game');
  assert.ok(!existsSync(join(folder, 'game.rec')));
  await user.clicks('button', 'Undo');

  await user.finds('button', GAME);
  assert.deepEqual(await readFile(join(folder, 'game.rec')), before);
  assert.ok(existsSync(join(folder, 'game.notes')));
  assert.equal((await about(folder, 'game')).agent, 'Agent_Wave');
});

slow('a bookmark is kept beside the recording, leads to its moment and can be deleted and restored', async (t) => {
  const { user, folder } = await openRecordings(t);
  await user.clicks('button', GAME);
  await user.sees(/0\.00 of [34]\.\d\d s/);
  await user.presses('PageDown', 'm');
  await user.types('here it stumbles');
  await user.clicks('button', 'Add');
  await user.finds('button', '1.00 s here it stumbles');
  assert.deepEqual((await about(folder, 'game')).bookmarks, [{ seconds: 1, note: 'here it stumbles' }]);

  await user.presses('End');
  await user.seesNo('1.00 of');
  await user.clicks('button', '1.00 s here it stumbles');
  await user.sees('1.00 of');

  await user.clicks('button', 'Delete the bookmark at 1.00 s');
  await user.findsNo('button', '1.00 s here it stumbles');
  await user.clicks('button', 'Undo');
  await user.finds('button', '1.00 s here it stumbles');
});

slow('an address shows a moment of a recording, or plays it', async (t) => {
  const { user, visit } = await openRecordings(t);

  await visit('replay/game@1.5');
  await user.sees('1.50 of');
  await user.follows('#replay/game@2');
  await user.sees('2.00 of');
  await user.fills('combobox', 'Speed of the replay', '0.1');
  await user.follows('#replay/game@play');

  await user.finds('button', '❚❚ Pause');
  await user.sees(/[01]\.\d\d of/);
});
