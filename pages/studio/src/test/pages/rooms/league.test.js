/**
 * A person watches and replays a match of RCSSServerMJ 0.2.1, from its log: two T1 of Blue and a K1 of Red. A T1 falls, Red scores, and the
 * other T1 lies on the ground for too long.
 */
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { readFile, writeFile } from 'node:fs/promises';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gunzipSync } from 'node:zlib';
import { folderWith, startCommand } from '../stage.js';
import { atEnd, picture, slow } from '../tests.js';
import { FOR_PICTURES, newUser } from '../user.js';

const LOGS = new URL('../../resources/org/robonewbie/studio/monitor/', import.meta.url);
const LOG = new URL('rsmp_t1_k1_goal_foul.log.gz', LOGS);
/** A T1 waves, then walks ahead. */
const WAVE_AND_WALK = new URL('rsmp_t1_wave_walk.log.gz', LOGS);
const FOUL = '2 lies on the ground for too long';
const STANDING_T1 = [-3, 4, 0.6];

/** Opens the studio by its command, at the place that it shows first. */
async function openByCommand(t, folder, words, { quality = 'lowest', theme = 'light', ...look } = {}) {
  const address = new URL(await startCommand(t, folder, 'studio', ...words, '--agent-port', '0'));
  address.searchParams.set('quality', quality);
  address.searchParams.set('theme', theme);
  const user = await newUser(t, look);
  await user.visits(address.href);
  return { user, folder };
}

/** Opens a log in the Replay room, and waits until it is shown at a moment. */
async function openLog(t, seconds, look, log = LOG) {
  const folder = await folderWith(t, { 'match.log.gz': await readFile(log) });
  const { user } = await openByCommand(t, folder, ['match.log.gz'], look);
  await user.sees(log === LOG ? 'of 21.36 s' : 'of 12.96 s');
  await goTo(user, seconds);
  return { user, folder };
}

async function goTo(user, seconds) {
  await user.follows(`replay/match@${seconds}`);
  await user.sees(`${seconds.toFixed(2)} of `);
}

/** Starts a server that sends the first message of the log when a monitor connects, and the rest when it orders the kick-off. */
async function serveLog(t) {
  const [first, ...others] = gunzipSync(await readFile(LOG))
    .toString()
    .trimEnd()
    .split('\n');
  const orders = [];
  const server = createServer((client) => {
    send(client, first);
    atEnd(t, () => client.destroy());
    client.on('error', () => undefined);
    client.on('data', (data) => {
      orders.push(data.toString());
      if (orders.at(-1).includes('kickOff')) {
        others.forEach((message) => send(client, message));
      }
    });
  });
  atEnd(t, () => server.close());
  await once(server.listen(0, '127.0.0.1'), 'listening');
  return { port: server.address().port, orders };
}

function send(client, message) {
  const length = Buffer.alloc(4);
  length.writeUInt32BE(Buffer.byteLength(message));
  client.write(Buffer.concat([length, Buffer.from(message)]));
}

const marks = ({ page }) => page.$$eval('.replay-line .event title', (all) => all.map((each) => each.textContent));

slow('a log is replayed with its events, its score and its robots', async (t) => {
  const { user } = await openLog(t, 3);

  await user.reads('region', 'Scoreboard', /Blue\s+0 : 0\s+Red[^]*Kick-off · Blue/);
  await goTo(user, 5);
  await user.reads('region', 'Scoreboard', /Blue\s+0 : 1\s+Red[^]*Goal · Red/);
  await user.findsNo('button', 'Log'); // it would have to be one of SimSpark, which has NAOs only
  const events = (await marks(user)).map((each) => each.replace(/^.* · /, ''));
  assert.deepEqual(events.slice(0, 6), [
    'Fall: Blue 1',
    'Play mode: KickOff_Left',
    'Play mode: PlayOn',
    'Goal: right Red',
    'Play mode: Goal_Right',
    'Fall: Blue 2',
  ]);
  assert.ok(events.includes(`Foul: left ${FOUL}`), events.join());
  await goTo(user, 20);
  await user.clicks('button', 'Next event');
  await user.reads('alert', '', FOUL);
});

slow('pitch and T1 are visible from afar and from near', async (t) => {
  const { user } = await openLog(t, 2.5, { isSharp: true, quality: 'high', width: 800, height: 600 });
  const colourAt = async (...place) => (await user.coloursAround(await user.pointOf(...place), 0))[0];

  await user.looks({ target: [0, -3.6, 0], azimuthDegrees: -90, elevationDegrees: 36, distance: 62 });
  for (const place of [
    [-20, 8, 0],
    [12, -9, 0],
  ]) {
    const [red, green, blue] = await colourAt(...place);
    assert.ok(green > Math.max(red, blue) + 25, `grass of the colour ${[red, green, blue]}`);
  }
  await user.looks({ target: STANDING_T1, azimuthDegrees: 30, elevationDegrees: 10, distance: 3 });
  const shell = await colourAt(...STANDING_T1);
  assert.ok(Math.max(...shell) - Math.min(...shell) < 40, `a T1 of the colour ${shell}`);
});

slow('all joints of a T1 have curves', async (t) => {
  const { user } = await openLog(t, 1);

  await user.clicks('link', 'Robot');

  await user.reads('region', 'Body', /Waist\s+-?\d\.\d°/);
  await user.reads('region', 'Left leg', /Knee pitch\s+\d\d\.\d°/);
  await user.seesNo('The world is waiting for an agent');
  await user.clicks('button', '+ Plot');
  await user.clicks('DisclosureTriangle', 'Choose values');
  await user.clicks('DisclosureTriangle', 'joint angle');
  assert.equal((await user.page.$$('[data-value^="joint angle/"]')).length, 23);
  await user.clicks('checkbox', 'waist');
  await user.reads('group', 'Plot of joint angle/waist', /joint angle: waist -?\d\.\d\d °/);
});

slow('a table and a single page hold the match', async (t) => {
  const { user, folder } = await openLog(t, 3);

  const table = await user.downloads(() => user.clicks('button', 'CSV'));
  const [head, ...rows] = table.bytes.toString().trimEnd().split('\n');
  assert.ok(head.includes('Blue_1_waist'), head);
  assert.equal(rows.length, 1069);
  const { name, bytes } = await user.downloads(() => user.clicks('button', 'HTML'));
  await writeFile(join(folder, name), bytes);
  user.expectsComplaints(/file:/);
  await user.visits(pathToFileURL(join(folder, name)).href);

  await user.sees(/([1-9]\.\d|0\.[1-9]) of 21\.4/);
  await user.until(() => user.page.evaluate(() => window.player.view.robots.poses.length === 3));
});

slow('a match is watched, and orders are those that the server knows', async (t) => {
  const { port, orders } = await serveLog(t);
  const { user } = await openByCommand(t, await folderWith(t), ['--monitor', `127.0.0.1:${port}`]);
  await user.sees('Blue 1');
  await user.reads('region', 'First steps', 'Drag the ball somewhere else');
  await user.seesNo('Add a puppet');
  await user.findsNo('link', 'Program');
  await user.findsNo('link', 'Exercises');
  await user.clicks('button', 'Tools ▾');
  await user.findsNo('region', 'Puppet');

  await user.clicks('button', '◀ Kick off');

  await user.reads('region', 'Scoreboard', /Blue\s+0 : 1\s+Red/);
  assert.ok(
    orders.some((order) => order.includes('(kickOff Left)')),
    orders.join(),
  );
  await user.until(() => user.page.evaluate(() => studio.view.robots.poses.length === 3));
});

picture('the documentation shows the league of today', async (t) => {
  const { user } = await openLog(t, 3.6, FOR_PICTURES);

  await user.looks({ target: [-0.3, 0.3, 0.3], azimuthDegrees: -60, elevationDegrees: 12, distance: 5.5 });

  await user.takesAPicture('league');
});

picture('the documentation shows a T1 that waves', async (t) => {
  const { user } = await openLog(t, 4, FOR_PICTURES, WAVE_AND_WALK);

  await user.looks({ target: [-2, 0.3, 0.6], azimuthDegrees: 25, elevationDegrees: 8, distance: 3.2 });

  await user.takesAPicture('t1-waves');
});

picture('the documentation shows a T1 that walks', async (t) => {
  const { user } = await openLog(t, 11, FOR_PICTURES, WAVE_AND_WALK);

  await user.looks({ target: [-1.3, 0.3, 0.5], azimuthDegrees: -60, elevationDegrees: 8, distance: 3.2 });

  await user.takesAPicture('t1-walks');
});
