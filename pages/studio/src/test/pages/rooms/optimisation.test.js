/** The page that shows the progress of an optimisation. */
import assert from 'node:assert/strict';
import { picture, slow } from '../tests.js';
import { folderWith, openStage } from '../stage.js';
import { FOR_PICTURES, newUser } from '../user.js';

const ROUNDS = 30;
const TASK = {
  subject: 'kick-right',
  objective: 'kick-distance',
  unit: 'm',
  isLargerBetter: true,
  rounds: ROUNDS,
  method: '30 rounds of 12 candidates with 4 trials each',
};
const JOINTS = ['right hip pitch', 'right knee pitch', 'right foot pitch', 'left hip roll'];

async function openSearch(t, look) {
  const folder = await folderWith(t, { 'kick-so-far.txt': `200${' 0'.repeat(22)}\n` });
  const stage = await openStage(t, folder, { search: TASK });
  await stage.search({ begins: 5.612 });
  const user = await newUser(t, look);
  const visit = async (options = '') => {
    await user.visits((await stage.address()).replace('/?', '/optimise.html?') + options);
  };
  return { stage, user, visit };
}

/** Publishes rounds of an optimisation that improves and converges. */
async function reach(stage, from, to) {
  for (let number = from; number <= to; number++) {
    const settled = 1 - Math.exp(-number / 8);
    const step = 0.15 * (1 + 0.2 * Math.sin(number / 3)) * Math.exp(-number / 25);
    const round = {
      number,
      best: 5.6 + 0.5 * settled + 0.03 * Math.sin(3 * number),
      mean: 5.2 + 0.8 * settled + 0.05 * Math.cos(2 * number),
      success: 0.8 + 0.2 * settled,
      step,
      trialsPerSecond: 11.4,
      secondsLeft: 4.2 * (ROUNDS - number),
    };
    await stage.search({ round, numbers: numbersAt(settled, step), place: '#motion/kick-so-far' });
  }
}

function numbersAt(settled, step) {
  return [1, 2, 3].flatMap((keyframe) =>
    JOINTS.map((joint, i) => {
      const start = 12.5 * keyframe - 30;
      const value = start + 4 * settled * Math.sin(2.3 * keyframe + i);
      return { name: `keyframe ${keyframe}, ${joint}`, unit: 'degrees', start, value, spread: 5 * step, size: 5 };
    }),
  );
}

/** Waits until both plots show a number of rounds. */
const plotsRounds = (user, count) =>
  user.until(() =>
    user.page.evaluate(
      (rounds) => window.search.valuePlot.data[0].length === rounds && window.search.stepPlot.data[1].length === rounds,
      count,
    ),
  );

const TWELVE_NUMBERS = /(keyframe \d, [a-z ]+\s+[-\d.]+ → [-\d.]+ degrees\s*){12}$/;

slow('progress is drawn while it is made', async (t) => {
  const { user, stage, visit } = await openSearch(t);
  await visit();
  await user.sees('first candidates');

  await reach(stage, 1, 4);

  await user.reads('region', 'Progress', '4 of 30');
  await plotsRounds(user, 4);
  assert.equal((await user.page.$$('.plot canvas')).length, 2);
  await user.reads('region', 'Numbers', TWELVE_NUMBERS);
});

slow('the axis of rounds has whole numbers', async (t) => {
  const { user, stage, visit } = await openSearch(t);
  await visit();

  await reach(stage, 1, 2);

  await plotsRounds(user, 2);
  const labels = () => user.page.evaluate(() => window.search.valuePlot.axes[0]._splits);
  await user.until(async () => (await labels())?.length > 1);
  assert.ok((await labels()).every(Number.isInteger));
});

slow('a page that comes late sees the whole history', async (t) => {
  const { user, stage, visit } = await openSearch(t);
  await reach(stage, 1, 12);

  await visit();

  await plotsRounds(user, 12);
  await user.reads('region', 'Progress', '5.612 m');
});

slow('the motion as it is now opens in the editor', async (t) => {
  const { user, stage, visit } = await openSearch(t);
  await reach(stage, 1, 2);
  await visit();

  const link = await user.finds('link', 'Show the current motion');
  await user.visits(await link.evaluate(({ href }) => href));

  await user.until(() => user.page.$eval('#file-name', (title) => title.textContent === 'kick-so-far'));
});

slow('the result remains on the page when the program ends', async (t) => {
  const { user, stage, visit } = await openSearch(t);
  await visit();
  await reach(stage, 1, ROUNDS);
  await stage.search({ ends: 6.087, outcome: 'It is better. Written to kick.txt.', place: '#motion/kick' });
  await user.sees('Written to kick.txt');

  user.expectsComplaints(/WebSocket|ERR_CONNECTION/);
  await stage.close();

  await user.findsNo('link', 'Show the resulting motion');
  await user.reads('region', 'Progress', /6\.087 m[^]*Written to kick\.txt/);
  await plotsRounds(user, ROUNDS);
});

slow('the program waits for open pages', async (t) => {
  const { user, stage, visit } = await openSearch(t);
  await visit();
  await user.sees('first candidates');
  assert.equal(await stage.search(), true);

  await user.page.goto('about:blank');

  assert.equal(await stage.search({ awaitUnwatched: true }), false);
});

slow('a browser that is not signed in sees nothing', async (t) => {
  const { user, stage } = await openSearch(t);
  await reach(stage, 1, 2);
  user.expectsComplaints(/./);

  await user.visits(new URL('/optimise.html', await stage.address()).href);

  await user.sees('This browser is not signed in');
  await plotsRounds(user, 0);
});

picture('the page of an optimisation fits its width in both themes', async (t) => {
  const { user, stage, visit } = await openSearch(t, FOR_PICTURES);
  await reach(stage, 1, 22);
  for (const theme of ['dark', 'light']) {
    await visit(`&theme=${theme}`);
    await plotsRounds(user, 22);
    await user.reads('region', 'Numbers', TWELVE_NUMBERS);
    assert.equal(await user.page.evaluate(() => document.documentElement.scrollWidth), 1366);
  }
  await user.takesAPicture('studio-optimise');
});
