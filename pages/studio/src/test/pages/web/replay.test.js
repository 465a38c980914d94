/** Recordings of the web edition in its Replay room. */
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { folderWith } from '../stage.js';
import { quick } from '../tests.js';
import { openStudio, openWebEdition } from '../user.js';

const plays = (agent) => `?agent=${agent}`;

/** Opens the Replay room once the agent of the page has been recorded for two seconds. */
async function opensReplay(user) {
  await user.sees(/cycle \d{3}/);
  await user.clicks('link', 'Replay');
}

/** Opens the web edition, and its Replay room once it has recorded agents, one after the other. */
async function openRuns(t, first, ...others) {
  const { user, visit } = await openWebEdition(t, { to: plays(first) });
  for (const agent of others) {
    await user.sees(/cycle \d{3}/);
    await visit(plays(agent));
  }
  await opensReplay(user);
  return { user, visit };
}

/** Waits until there are as many recordings as this, and returns their names, the newest first. */
async function recordings(user, count) {
  const names = () => user.page.$$eval('#recordings article', (cards) => cards.map(({ ariaLabel }) => ariaLabel));
  await user.until(
    async () => (await names()).length === count,
    () => `has ${count} recordings`,
  );
  return names();
}

/** Returns the seconds of the shown recording, once there are more than two. */
async function seconds(user) {
  const [, total] = (await user.reads('region', 'Replay', /of ([2-9]|\d\d)\.\d\d s/)).match(/of (\S+) s/);
  return Number(total);
}

/** Opens a recording by its name, and returns its seconds. */
async function opens(user, name) {
  await user.follows(`#replay/${encodeURIComponent(name)}`);
  await user.reads('region', 'Replay', name);
  return seconds(user);
}

async function opensAFile(t, user, name, content) {
  const folder = await folderWith(t, { [name]: content });
  const [choice] = await Promise.all([user.page.waitForFileChooser(), user.clicks('button', 'Open a file…')]);
  await choice.accept([join(folder, name)]);
}

quick('the run of the page is shown from its beginning and grows', async (t) => {
  const { user } = await openRuns(t, 'Agent_BetterSoccer');
  const [name] = await recordings(user, 1);
  const before = await opens(user, name);

  await user.until(async () => (await seconds(user)) > before + 2);
  await user.presses('Home');

  await user.sees('0.00 of');
  await user.sees('new robot');
});

quick('a recording and its bookmark are there again after a visit', async (t) => {
  const { user, visit } = await openRuns(t, 'Agent_BetterSoccer');
  const [name] = await recordings(user, 1);
  await opens(user, name);
  await user.presses('Home', 'm');
  await user.types('where it begins');
  await user.clicks('button', 'Add');
  await user.finds('button', '0.00 s where it begins');

  await visit(plays('Agent_Dance'));
  await opensReplay(user);

  const [other] = await recordings(user, 2);
  await user.reads('article', other, 'Agent_Dance');
  await user.reads('article', name, /1 robot.*Agent_BetterSoccer · 1 bookmark/s);
  await opens(user, name);
  await user.clicks('DisclosureTriangle', 'Bookmarks (1)');
  await user.finds('button', '0.00 s where it begins');
});

quick('a deleted recording is restored', async (t) => {
  const { user } = await openRuns(t, 'Agent_BetterSoccer', 'Agent_Dance');
  const before = await recordings(user, 2);

  await user.clicks('button', `Delete ${before[1]}`);
  await user.findsNo('article', before[1]);
  await user.clicks('button', 'Undo');

  await user.reads('article', before[1], '1 robot');
  assert.deepEqual(await recordings(user, 2), before);
});

quick('a downloaded recording is the same in the studio, and in the page again', async (t) => {
  const { user } = await openRuns(t, 'Agent_BetterSoccer', 'Agent_Dance');
  const [, name] = await recordings(user, 2);
  const length = await opens(user, name);

  const file = await user.downloads(() => user.clicks('button', 'File'));
  const log = await user.downloads(() => user.clicks('button', 'Log'));

  assert.equal(file.name, `${name}.rec`);
  const { user: other } = await openStudio(t, { room: 'replay/game', files: { 'game.rec': file.bytes } });
  assert.equal(await seconds(other), length);
  const expected = await other.downloads(() => other.clicks('button', 'Log'));
  assert.deepEqual(gunzipSync(log.bytes), gunzipSync(expected.bytes));
  await user.clicks('button', 'Recordings');
  await opensAFile(t, user, 'game.rec', file.bytes);
  await user.reads('region', 'Replay', 'game');
  assert.equal(await seconds(user), length);
});

quick('a file that is no recording is refused', async (t) => {
  const { user } = await openRuns(t, 'Agent_BetterSoccer');

  await opensAFile(t, user, 'letter.rec', 'Hello');

  await user.reads('alert', '', '“letter.rec” is not a RoboNewbie recording');
});

quick('lines of the log stand on the time line', async (t) => {
  const { user } = await openRuns(t, 'Agent_BasicStructure');
  const [name] = await recordings(user, 1);

  await opens(user, name);

  const marks = () => user.page.$$eval('.replay-line .event title', (all) => all.map((mark) => mark.textContent));
  await user.until(async () => (await marks()).some((text) => text.includes('Log: RoboNewbie 1 says ')));
});
