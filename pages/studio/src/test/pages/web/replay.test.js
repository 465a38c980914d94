/** Recordings of the web edition in its Replay room. */
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { folderWith } from '../stage.js';
import { quick } from '../tests.js';
import { openStudio, openWebEdition } from '../user.js';

const NOTE = '0.00 s where it begins';

/** Opens the web edition, which records its run from the beginning. */
async function openPage(t) {
  const { user, visit } = await openWebEdition(t);
  await user.sees(/cycle \d{3}/);
  const begins = async (agent) => {
    await visit(`?agent=${agent}`);
    await user.sees(/cycle \d{3}/);
  };
  return { user, begins };
}

/** Returns the names of all recordings, the newest first. */
const recordings = (user) =>
  user.page.evaluate(async () => (await (await fetch('api/recordings')).json()).recordings.map(({ name }) => name));

/** Returns the seconds of the shown recording, once there are more than two. */
async function length(user) {
  const [, seconds] = (await user.reads('region', 'Replay', /of ([2-9]|\d\d)\.\d\d s/)).match(/of (\S+) s/);
  return Number(seconds);
}

/** Shows a recording by its place in the list. */
async function shows(user, index) {
  const name = (await recordings(user))[index];
  await user.follows(`#replay/${encodeURIComponent(name)}`);
  await user.reads('region', 'Replay', name);
  await length(user);
  return name;
}

async function opensAFile(user, t, name, content) {
  const path = join(await folderWith(t, { [name]: content }), name);
  if (!(await user.text()).includes('Open a file…')) {
    await user.clicks('button', 'Recordings');
  }
  const [chooser] = await Promise.all([user.page.waitForFileChooser(), user.clicks('button', 'Open a file…')]);
  await chooser.accept([path]);
}

quick('the run of the page is shown from its beginning and grows', async (t) => {
  const { user } = await openPage(t);
  await shows(user, 0);
  const before = await length(user);
  await user.until(async () => (await length(user)) > before + 2);

  await user.presses('Home');

  await user.reads('region', 'Replay', '0.00 of');
  await user.sees('RoboNewbie 1');
});

quick('a recording and its bookmark are there again after a visit', async (t) => {
  const { user, begins } = await openPage(t);
  const name = await shows(user, 0);
  await user.presses('Home', 'm');
  await user.fills('textbox', 'Note for this moment', 'where it begins');
  await user.clicks('button', 'Add');
  await user.sees(NOTE);

  await begins('Agent_Dance');

  assert.equal(await shows(user, 1), name);
  await user.presses('m');
  await user.sees(NOTE);
  await user.sees('RoboNewbie 1');
  await user.clicks('button', 'Recordings');
  const cards = await user.reads('region', 'Recordings', /Agent_Dance.*Agent_BetterSoccer/s);
  assert.equal(cards.match(/Agent_/g).length, 2);
});

quick('a deleted recording is restored', async (t) => {
  const { user, begins } = await openPage(t);
  await begins('Agent_Dance');
  await shows(user, 0);
  const before = await recordings(user);
  await user.clicks('button', 'Recordings');
  await user.reads('region', 'Recordings', before[1]);

  await user.clicks('button', 'Delete');
  await user.until(async () => !(await user.reads('region', 'Recordings')).includes(before[1]));
  await user.clicks('button', 'Undo');

  await user.reads('region', 'Recordings', new RegExp(`1 robot[^A]*Agent_BetterSoccer\\s+${before[1]}`));
  assert.deepEqual(await recordings(user), before);
});

quick('a recording is downloaded and imported', async (t) => {
  const { user } = await openPage(t);
  await shows(user, 0);
  const { name, bytes } = await user.downloads(() => user.clicks('button', 'File'));
  assert.match(name, /\.rec$/);

  await opensAFile(user, t, 'game.rec', bytes);

  await user.reads('region', 'Replay', 'game');
  const studio = await openStudio(t, { room: 'replay/game', files: { 'game.rec': bytes } });
  assert.equal(await length(user), await length(studio.user));
});

quick('a file that is no recording is refused', async (t) => {
  const { user } = await openPage(t);
  await shows(user, 0);

  await opensAFile(user, t, 'letter.rec', 'Hello');

  await user.sees('“letter.rec” is not a RoboNewbie recording');
});

quick('the log for other viewers is that of the studio', async (t) => {
  const { user, begins } = await openPage(t);
  await begins('Agent_Dance');
  const name = await shows(user, 1);
  const file = await user.downloads(() => user.clicks('button', 'File'));

  const log = await user.downloads(() => user.clicks('button', 'Log'));

  const place = `replay/${encodeURIComponent(name)}`;
  const studio = await openStudio(t, { room: place, files: { [file.name]: file.bytes } });
  const expected = await studio.user.downloads(() => studio.user.clicks('button', 'Log'));
  assert.deepEqual(gunzipSync(log.bytes), gunzipSync(expected.bytes));
});

quick('lines of the log stand on the time line', async (t) => {
  const { user, begins } = await openPage(t);
  await begins('Agent_BasicStructure');

  await shows(user, 0);

  await user.until(() =>
    user.page.evaluate(() =>
      [...document.querySelectorAll('#replay title')].some(({ textContent }) =>
        textContent.includes('Log: RoboNewbie 1 says '),
      ),
    ),
  );
});
