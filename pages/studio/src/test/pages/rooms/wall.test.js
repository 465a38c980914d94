/** Spectators of a contest see all running trials side by side, and the table of results. */
import assert from 'node:assert/strict';
import { findsNoBarrier } from '../accessibility.js';
import { folderWith, openStage } from '../stage.js';
import { slow } from '../tests.js';
import { FOR_PICTURES, newUser } from '../user.js';

const ALONE = 'http://127.0.0.1:3999/';
const TEAMS = ['Red', 'Blue'];

const tableWith = (over, cell) => ({
  over,
  planned: 2,
  columns: ['Goal after', 'Trial'],
  rows: [
    { rank: 1, team: 'Red', cells: [cell, 'played to the end'] },
    { rank: 2, team: 'Blue', cells: ['–', 'not yet'] },
  ],
});

/** Opens the page of a contest with two running trials; `wall` publishes news. */
async function openWall(t, { theme = 'light', ...look } = {}) {
  const folder = await folderWith(t);
  const contest = await openStage(t, folder, { hasWall: true });
  await contest.wall({ table: tableWith(0, 'not yet') });
  const trials = [];
  for (const team of TEAMS) {
    trials.push(await openStage(t, folder, { robots: [{}] }));
    await contest.wall({ begins: `scoring-${team}`, team, in: trials.at(-1).id, at: ALONE });
  }
  const user = await newUser(t, look);
  await user.visits(`${(await contest.address()).replace('/?', '/wall.html?')}&theme=${theme}`);
  return { user, contest, trials };
}

const tile = (team) => `[data-trial="scoring-${team}"]`;

/** Waits until the ball of a trial is shown at a distance from the halfway line. */
async function seesBallAt(user, team, x) {
  const ball = await user.page.waitForSelector(`${tile(team)} circle.ball[cx]`);
  await user.until(
    async () => Math.abs(x - (await ball.evaluate((shape) => shape.getAttribute('cx')))) < 0.05,
    () => `sees the ball of ${team} at ${x}`,
  );
}

slow('running trials move side by side and lead to their own pages', async (t) => {
  const { user, trials } = await openWall(t);
  await seesBallAt(user, 'Red', 0);
  await seesBallAt(user, 'Blue', 0);

  await trials[0].order({ do: 'placeBall', x: 3, y: 1, z: 0.04 });
  await trials[1].order({ do: 'placeBall', x: -2, y: 1, z: 0.04 });

  await seesBallAt(user, 'Red', 3);
  await seesBallAt(user, 'Blue', -2);
  for (const team of TEAMS) {
    assert.equal(await user.page.$eval(tile(team), (link) => link.href), ALONE);
    assert.equal((await user.page.$$(`${tile(team)} .robot`)).length, 1);
  }
});

slow('the table grows with each trial that is over, whose tile then leads to its recording', async (t) => {
  const { user, contest } = await openWall(t);
  await user.reads('region', 'Table', 'not yet');
  await seesBallAt(user, 'Red', 0);

  await contest.wall({ ends: 'scoring-Red' });
  await contest.wall({ result: 'Red goal 12.3', of: 'scoring-Red' });
  await contest.wall({ table: tableWith(1, '12.30 s') });

  await user.reads('region', 'Table', '12.30 s');
  await user.sees('after 1 of 2 trials');
  const recording = await user.finds('link', 'scoring-Red');
  assert.match(await recording.evaluate((link) => link.href), /#replay\/scoring-Red$/);
  await user.reads('region', 'Trials', 'scoring-Red · Over');
  await user.reads('region', 'Trials', /scoring-Blue · (?!Over)/);
});

slow('the table remains on the page when the program ends', async (t) => {
  const { user, contest } = await openWall(t);
  user.expectsComplaints(/ERR_|WebSocket/);
  await seesBallAt(user, 'Red', 0);
  await contest.wall({ outcome: 'Table: table.html' });
  await user.sees('The competition is over. Table: table.html');

  await contest.close();

  await user.reads('region', 'Trials', 'scoring-Red · Over');
  await user.reads('region', 'Trials', 'scoring-Blue · Over');
  await user.reads('region', 'Table', /^The competition is over. Table: table.html$/m);
});

slow('unknown browsers see nothing of a contest', async (t) => {
  const { contest } = await openWall(t);
  const stranger = await newUser(t);
  stranger.expectsComplaints(/status of 4\d\d|WebSocket/);

  await stranger.visits(new URL('/wall.html', await contest.address()).href);

  await stranger.sees('This browser is not signed in');
  await stranger.seesNo(/Red|Blue/);
});

for (const theme of ['light', 'dark']) {
  slow(`the wall of a contest has no barrier in the ${theme} theme`, async (t) => {
    const { user, contest } = await openWall(t, { theme });
    await contest.wall({ ends: 'scoring-Red' });
    await contest.wall({ result: 'Red goal 12.3', of: 'scoring-Red' });
    await user.finds('link', 'scoring-Red');
    await seesBallAt(user, 'Blue', 0);

    await findsNoBarrier(user, 'the wall');
  });

  slow(`the wall of a contest fits on its page in the ${theme} theme`, async (t) => {
    const { user, contest } = await openWall(t, { theme, ...FOR_PICTURES });
    await contest.wall({ result: 'Green goal 8.46', of: 'scoring-Green' });
    await contest.wall({ table: tableWith(1, '8.46 s') });
    await user.sees('8.46 s');
    await seesBallAt(user, 'Blue', 0);

    assert.equal(await user.page.evaluate(() => document.documentElement.scrollWidth), 1366);
    await user.takesAPicture(`studio-wall-${theme}`);
  });
}
