/** A student replays a recording: its events, its moments, and a second run beside it. */
import assert from 'node:assert/strict';
import { copyFile } from 'node:fs/promises';
import { join } from 'node:path';
import { picture, quick, slow } from '../tests.js';
import { FOR_PICTURES } from '../user.js';
import { boxOf, openReplay, WHOLE } from './replay-room.js';

const NOTES = [
  { seconds: 1, robot: 'Blue Newbies 1', level: 'INFO', text: 'I see the ball' },
  { seconds: 2, robot: 'Blue Newbies 1', level: 'WARNING', text: 'the joint is too fast' },
  {
    drawn: 'draw\t1.0\tAda\t1\tcircle\tcyan\t1.0\t0.0\t-0.5\t0.4\ttext\tcyan\t1.0\t0.0\t-0.5\tball <here>',
  },
];
const WARNING = 'Warning: Blue Newbies 1 says the joint is too fast';
const CARD_OF_OTHER = 'Ada 00:04 · 1 robot · 1 goal · 1 fall other';

const FILES = { 'game.notes': NOTES.map((note) => `${JSON.stringify(note)}\n`).join('') };

const openRun = (t, options = {}) => openReplay(t, { files: FILES, ...options });

/** Opens a studio with two equal recordings. */
async function openTwoRuns(t, room) {
  const studio = await openRun(t, { room: 'replay' });
  await copyFile(join(studio.folder, 'game.rec'), join(studio.folder, 'other.rec'));
  await studio.visit(room);
  return studio;
}

/** Returns the texts of the marks on the time line. */
const marks = ({ page }) => page.$$eval('.replay-line .event title', (all) => all.map((each) => each.textContent));

/** Returns the heights of the robots in the 3D picture. */
const heights = ({ page }) => page.evaluate(() => studio.view.robots.poses.map((pose) => pose[2]));

/** Returns the number of circle corners and the text that the robot drew, if the picture shows them. */
const drawings = ({ page }) =>
  page.evaluate(() => {
    const { group, shapes, texts } = studio.view.drawings;
    return group.visible ? [shapes.geometry.getAttribute('position').count, texts.children[0]?.name] : [];
  });

quick('a recorded run is shown with its events', async (t) => {
  const { user } = await openRun(t);

  await user.presses('End');

  await user.reads('region', 'Scoreboard', /Ada/);
  const texts = await marks(user);
  assert.equal(texts.filter((text) => text.includes('Goal:')).length, 1);
  assert.match(texts.join(), /Fall:.*Play mode:|Play mode:.*Fall:/);
});

slow('lines of logs are marked, and warnings are events', async (t) => {
  const { user } = await openRun(t);
  await user.until(async () => (await marks(user)).some((text) => text.endsWith(WARNING)));
  assert.equal((await marks(user)).filter((text) => text.includes('Log:')).length, 1);

  await user.presses('Home');
  for (let presses = 0; presses < 12 && !(await user.text()).includes(WARNING); presses++) {
    await user.clicks('button', 'Next event');
  }

  await user.reads('alert', '', WARNING);
  await user.sees(/(1\.9|2\.0)\d of/);
});

slow('dragging the time line moves robots and score', async (t) => {
  const { user } = await openRun(t);
  const { x: left, y: top, width } = await (await user.finds('slider', 'Moment of the recording')).boundingBox();
  const right = left + width;

  await user.page.mouse.click(left + 60, top + 28);
  await user.sees(/0\.[12]\d of/);
  await user.findsNo('region', 'Scoreboard'); // as long as there is no goal
  await user.until(async () => (await heights(user)).length === 1);
  const [before] = await heights(user);
  await user.drags([left + 60, top + 28], [right - 14, top + 28]);

  await user.reads('region', 'Scoreboard', /1\s*:\s*0/);
  await user.until(async () => (await heights(user))[0] < before - 0.1);
  await user.sees(/([34]\.\d)\d of \1\d s/);
});

slow('events and cycles are jumped to, and the run is played', async (t) => {
  const { user } = await openRun(t);
  await user.clicks('button', 'Next event');
  await user.reads('alert', '', /Play mode|Goal/);
  await user.presses('Home');
  await user.sees('0.00 of');
  await user.presses('ArrowRight');
  await user.sees('0.02 of');
  await (await user.finds('slider', 'Moment of the recording')).focus();
  await user.presses('ArrowRight');
  await user.sees('0.04 of');

  await user.fills('combobox', 'Speed of the replay', '8');
  await user.clicks('button', '▶ Play');

  await user.sees(/(\d\.\d\d) of \1 s/);
  await user.finds('button', '▶ Play');
});

slow('the field shows the same moment until one goes back to now', async (t) => {
  const { user } = await openRun(t);

  await user.clicks('link', 'Field');
  await user.reads('region', 'Shown moment', 'Recording game at');
  await user.finds('application', 'The pitch in three dimensions. Arrow keys turn the view.');
  await user.clicks('button', 'Live');

  await user.reads('region', 'Shown moment', /now$/);
  await user.sees('Blue_Newbies 1');
  await user.finds('region', 'Time');
});

slow('opening the replay keeps the live view until a recording is chosen', async (t) => {
  const { user } = await openRun(t, { room: 'replay' });
  await user.finds('article', 'game');

  await user.clicks('link', 'Field');

  await user.reads('region', 'Shown moment', /now$/);
  await user.sees('Blue_Newbies 1');
});

slow('a second run is compared by ghosts, in a bar that keeps its height', async (t) => {
  const { user } = await openTwoRuns(t, 'replay/game');

  await user.fills('combobox', 'Compare with', 'other');

  await user.reads('region', 'Replay', /Distance, 0 to 0\.05 m\s*Here: .*0\.00 m/);
  await user.until(async () => (await heights(user)).length === 2);
  assert.ok((await user.page.$eval('.compare-curve polyline', (curve) => curve.points.length)) > 20);
  const before = await boxOf(user, '#replay');
  const long = `Here: ball 10.00 m${[1, 2, 3, 4].map((number) => ` · ${number} 10.00 m`).join('')}`;
  const height = await user.page.evaluate((text) => {
    document.querySelector('#compare-reading').textContent = text;
    return document.querySelector('#replay').getBoundingClientRect().height;
  }, long);
  assert.equal(height, before.bottom - before.top);
});

slow('drawings of a robot stay on the ground for a second', async (t) => {
  const { user } = await openRun(t);
  const shows = (...wanted) => user.until(async () => String(await drawings(user)) === String(wanted));
  const drawn = [48 * 6, 'ball <here>'];
  await user.presses('Home');
  await user.sees('0.00 of');
  await shows();

  await user.presses('PageDown');

  await shows(...drawn);
  await user.presses('d');
  await shows();
  await user.presses('d');
  await shows(...drawn);
  await user.presses('PageDown');
  await shows();
});

slow('recordings are cards that are searched and chosen', async (t) => {
  const { user } = await openTwoRuns(t, 'replay');
  await user.reads('article', 'game', /Ada\s*00:04 · 1 robot · 1 goal · 1 fall\s*game/);
  const card = await user.finds('article', 'game');
  assert.equal((await card.$$('circle.left, circle.ball')).length, 2);
  assert.ok((await card.$eval('.way.ball', (path) => path.points.length)) > 50);

  await user.fills('searchbox', 'Search recordings', 'oth');
  await user.findsNo('article', 'game');
  await user.clicks('button', CARD_OF_OTHER);

  await user.findsNo('region', 'Recordings');
  await user.reads('region', 'Replay', 'other');
  await user.sees(WHOLE);
});

slow('the marks of the time line have a legend', async (t) => {
  const { user } = await openRun(t);

  await user.reads('region', 'Replay', /Goal\s*Fall\s*Foul\s*Play mode\s*Warning\s*Log/);
});

slow('a replay without recordings says so', async (t) => {
  const { user } = await openRun(t, { room: 'replay', recordings: [], files: {} });

  await user.reads('region', 'Replay', 'Nothing has been recorded yet.');
});

picture('the replay fits the width of the page', async (t) => {
  const { user } = await openRun(t, FOR_PICTURES);

  await user.presses('End');

  await user.until(() => user.page.evaluate(() => studio.camera.isStill));
  await user.sees(/([34]\.\d\d) of \1 s/);
  await user.takesAPicture('studio-replay');
  assert.equal(await user.page.evaluate(() => document.documentElement.scrollWidth), 1366);
});
