/** A student inspects one robot: its joints, senses, surroundings, curves, log and messages. */
import assert from 'node:assert/strict';
import { picture, quick, slow } from '../tests.js';
import { FOR_PICTURES, openStudio } from '../user.js';

const TEAM = 'Blue_Newbies';
const LOG = ['list', 'Log of the robot'];
const SILENCE = 'This robot has logged nothing yet.';
const FIRST_PLOTS = [
  'torso/height',
  'ball/distance',
  'joint angle/left knee pitch, joint angle/right knee pitch',
  'accelerometer/forward, accelerometer/left, accelerometer/up',
];
const TWO_ROBOTS = [{}, { number: 2, type: 4, x: -3, y: -1, heading: 40 }];

async function openRobot(t, options = {}) {
  const studio = await openStudio(t, { room: 'robot', robots: TWO_ROBOTS, ...options });
  await studio.user.finds('group', `Plot of ${FIRST_PLOTS.at(-1)}`);
  return studio;
}

const secondsOf = async (stage) => (await stage.world()).cycle * 0.02;

/** Returns the time that the curves show. */
const shownSeconds = ({ page }) => page.evaluate(() => studio.robot.plots.moment.seconds);

/** Makes the first robot log a line, and waits until the page shows it; from then on the page knows its telemetry. */
async function say({ stage, user }, seconds, level, line) {
  await stage.tell('log', seconds, TEAM, 1, level, line);
  await user.reads(...LOG, line);
}

/** Pauses the world, and returns its time when the page shows it. */
async function pause({ stage, user }) {
  await stage.order({ do: 'pause' });
  await user.until(async () => (await stage.world()).isPaused);
  const seconds = await secondsOf(stage);
  await user.until(async () => Math.abs((await shownSeconds(user)) - seconds) < 0.001);
  return seconds;
}

/** Returns the names of all things on the map. */
const onTheMap = ({ page }) => page.$$eval('.map title', (all) => all.map((each) => each.textContent));

/** Opens a group of values that are drawn, or closes it. */
const turns = (user, group) => user.clicks('DisclosureTriangle', group);

quick('the joints and curves of the running robot are shown', async (t) => {
  const { user, stage } = await openRobot(t);

  await user.until(async () => {
    const [, degrees] = /Knee pitch\s+(-?[\d.]+)°/.exec(await user.reads('region', 'Left leg')) ?? [];
    return Math.abs(degrees - (await stage.world()).robots[0].degrees.LEFT_KNEE_PITCH) < 3;
  });
  await user.findsNo('region', 'Toes');
  await user.sees(/heading -?\d+°, standing/);
  for (const values of FIRST_PLOTS) {
    const plot = await user.finds('group', `Plot of ${values}`);
    await user.until(() => plot.$('canvas'));
  }
  assert.doesNotMatch(await user.text(), /-0°/);
});

slow('a robot shows its telemetry', async (t) => {
  const studio = await openRobot(t);
  const { user, stage } = studio;
  const now = await pause(studio);

  await say(studio, now, 'WARNING', 'the ball is <b>far</b>');
  await stage.tell('motion', now, TEAM, 1, 'walk-forward', 3);
  await stage.tell('plot', now, TEAM, 1, 'courage', 7);
  await stage.tell('belief', now, TEAM, 1, '-0.5', '0.4', '20', 'ball', '1', '0.2', '-0.4', '0', '1');

  await user.sees('Motion walk-forward, moving to keyframe 3');
  await user.until(async () => (await onTheMap(user)).includes('ball, seen 0.0 s ago (belief)'));
  const things = await onTheMap(user);
  assert.equal(things.filter((each) => each.endsWith('(belief)')).length, 1);
  assert.equal(things.filter((each) => each === 'believed position of the robot').length, 1);
  assert.equal(things.filter((each) => each.endsWith('(truth)')).length, 6);
  await turns(user, 'Choose values');
  await turns(user, 'agent');
  await user.finds('checkbox', 'courage');
});

slow('only the chosen robot is shown', async (t) => {
  const { user, stage } = await openRobot(t);

  await user.presses('n');
  await user.finds('region', 'Toes');
  await user.readsValue('combobox', 'Robot', '1');
  for (const [number, line] of [
    [1, 'one'],
    [2, 'two'],
  ]) {
    await stage.tell('log', 1, TEAM, number, 'INFO', line);
  }

  assert.doesNotMatch(await user.reads(...LOG, 'two'), /one/);
});

slow('drawings of older cycles vanish', async (t) => {
  const studio = await openRobot(t);
  const { user, stage } = studio;
  const drawings = async () => (await user.page.$$('.map .drawing')).length;
  const now = await pause(studio);
  await say(studio, now, 'INFO', 'I draw');
  await stage.tell('draw', now, TEAM, 1, 'circle', 'red', '0', '0', '0', '1');
  await user.until(async () => (await drawings()) === 1);

  await stage.order({ do: 'resume' });

  await user.until(async () => (await drawings()) === 0);
});

slow('the log is filtered by level', async (t) => {
  const studio = await openRobot(t);
  const { user, stage } = studio;
  await say(studio, await secondsOf(stage), 'DEBUG', 'detail');
  await say(studio, await secondsOf(stage), 'ERROR', 'mistake');

  await user.fills('combobox', 'Minimum level', 'WARNING');

  await user.reads(...LOG, /^(?![^]*detail)[^]*mistake/);
});

slow('an empty log says how to write into it', async (t) => {
  const studio = await openRobot(t);
  const { user, stage } = studio;
  await user.sees(SILENCE);
  await user.findsNo('combobox', 'Minimum level');

  await say(studio, await secondsOf(stage), 'INFO', 'I see the ball');

  await user.seesNo(SILENCE);
  await user.finds('combobox', 'Minimum level');
});

slow('chosen values are drawn together, held and saved as a table', async (t) => {
  const { user } = await openRobot(t);
  const table = async () => {
    const { name, bytes } = await user.downloads(() => user.clicks('button', 'CSV'));
    assert.equal(name, 'robot.csv');
    return bytes.toString().trimEnd().split('\n');
  };

  await user.clicks('button', '+ Plot');
  for (const [group, value] of [
    ['torso', 'x'],
    ['joint angle', 'neck yaw'],
  ]) {
    await turns(user, 'Choose values');
    await turns(user, group);
    await user.clicks('checkbox', value);
    await turns(user, 'Choose values');
  }

  await user.reads('group', 'Plot of torso/x, joint angle/neck yaw', /torso: x -?\d[^]*joint angle: neck yaw -?\d/);
  await user.until(async () => (await table()).length > 11);
  await user.clicks('button', 'Hold');
  const [head, ...held] = await table();
  assert.match(head, /^seconds,.*joint angle\/neck yaw/);
  const moment = await shownSeconds(user);
  await user.until(async () => (await shownSeconds(user)) > moment + 0.5);
  assert.equal((await table()).at(-1), held.at(-1));
});

slow('all rooms follow the shown moment while the simulation runs', async (t) => {
  const studio = await openRobot(t);
  const { user, stage } = studio;
  const then = await shownSeconds(user); // a moment that the page has received, of which there are fewer if it is slow
  const readsSeconds = (role, name, isRight) =>
    user.until(async () => isRight(parseFloat(/[\d.]+ s/.exec(await user.reads(role, name)))));
  const isThen = (seconds) => Math.abs(seconds - then) < 0.06;
  await say(studio, then, 'INFO', 'here I was');
  await user.until(async () => (await shownSeconds(user)) > then + 1);

  await user.clicks('button', `${then.toFixed(2)} s`);

  await readsSeconds('region', 'Shown moment', isThen);
  await user.until(async () => isThen(await shownSeconds(user)));
  await user.clicks('link', 'Field');
  await readsSeconds('region', 'Time', isThen);
  assert.ok((await secondsOf(stage)) > then + 0.9);
  await user.presses('End');
  await user.reads('region', 'Shown moment', /now$/);
  await readsSeconds('region', 'Time', (seconds) => seconds > then + 1);
});

picture('a playing robot is shown with what it sees, feels, shouts, orders and believes', async (t) => {
  const studio = await openRobot(t, { robots: [], isPlaying: true, ...FOR_PICTURES });
  const { user, stage } = studio;
  await user.until(async () => (await user.page.$$('.camera .post, .camera .field-line')).length > 3);
  await user.sees(/Left foot\s+\d+ N[^]*Right foot\s+\d+ N[^]*“step\d+”/);
  await user.reads('region', 'Left arm', /! -?\d+/);
  await turns(user, 'Choose values');
  for (const group of ['commanded speed', 'joint speed']) {
    await turns(user, group);
    await user.clicks('checkbox', 'neck pitch');
    await turns(user, `${group} (1)`);
  }
  await user.until(async () => (await shownSeconds(user)) > 4);
  const now = await pause(studio);
  for (let i = 0; i < 6; i++) {
    await stage.tell('log', i, 'Stars', 1, i === 4 ? 'WARNING' : 'INFO', `I have nodded ${i} times`);
  }
  await stage.tell('motion', 1, 'Stars', 1, 'nod', 3);
  await stage.tell('belief', now, 'Stars', 1, '-1.6', '0.3', '10', 'ball', '1.9', '-0.2', '-0.4', '0.1', '1');
  await user.until(async () => (await onTheMap(user)).includes('believed position of the robot'));
  await user.takesAPicture('studio-robot');

  await user.presses('m');
  await user.sees('(GYR (n torso)');
  await user.fills('searchbox', 'Search in the messages', 'lae1');
  await user.seesNo('GYR');
  await user.sees('(lae1 9.5)');
  assert.equal(await user.page.evaluate(() => document.documentElement.scrollWidth), 1366);
});

slow('names in the picture of the camera are not printed over each other', async (t) => {
  const { user } = await openRobot(t);

  const [covered, all] = await user.page.evaluate(async () => {
    const { cameraPicture } = await import(new URL('robot/camera-picture.js', document.baseURI).href);
    const place = document.querySelector('#robot-surroundings');
    const player = (metres, left) => ({
      name: `Blue ${metres}`,
      kind: 'player',
      team: 'Blue',
      points: [{ name: 'head', polar: [metres, left, 0] }],
    });
    cameraPicture(place)({ lines: [], things: Array.from({ length: 22 }, (_, i) => player(9 - i / 4, i)) }, 'Blue');
    const names = [...place.querySelectorAll(':scope > svg text:not([hidden])')];
    const boxes = names.map((name) => name.getBoundingClientRect()).filter(({ width }) => width > 0);
    const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
    return [boxes.filter((a, i) => boxes.some((b, j) => j < i && meet(a, b))).length, boxes.length];
  });

  assert.equal(covered, 0);
  assert.ok(all > 0);
});

slow('picture, curves, joints and words are seen together on a small screen', async (t) => {
  const { user } = await openRobot(t, { width: 1024, height: 768 });

  for (const [role, name] of [
    ['application', 'The pitch in three dimensions. Arrow keys turn the view.'],
    ['group', `Plot of ${FIRST_PLOTS[0]}`],
    ['region', 'Head'],
    ['button', 'Log'],
  ]) {
    const { x, y, width } = await (await user.finds(role, name)).boundingBox();
    assert.ok(width > 30 && x >= 0 && x + width <= 1024 && y >= 0 && y < 740, `${name} at ${x}, ${y}`);
  }
});
