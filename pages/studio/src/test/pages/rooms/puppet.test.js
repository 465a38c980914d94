/** The pitch without programming: a robot is steered by keys and sliders, scenes are saved and restored. */
import assert from 'node:assert/strict';
import { join } from '../agent.js';
import { slow } from '../tests.js';
import { FOR_PICTURES, openStudio } from '../user.js';

const ARM = 'left shoulder pitch';
const COMMAND = /\.\/robonewbie run Agent_BasicStructure --port (\d+)/;

/** Opens the Field room at double speed, with a world that waits for its first robot. */
async function openField(t, options = {}) {
  const studio = await openStudio(t, { speed: 2, ...options });
  await openTools(studio.user);
  return studio;
}

const openTools = (user) => user.clicks('button', 'Tools ▾');

/** Adds the first puppet and waits until it stands behind the ball. */
async function addPuppet(studio) {
  await studio.user.clicks('button', 'Add a puppet');
  await studio.user.sees('You are steering Puppets 1');
  await seesRobot(studio, ({ place }) => Math.hypot(place.x + 0.4, place.y) < 0.1);
}

/** Waits until the first robot is as a condition says. */
function seesRobot({ user, stage }, condition) {
  return user.until(async () => {
    const [robot] = (await stage.world()).robots;
    return robot && condition(robot);
  });
}

async function raiseArm(studio) {
  await studio.user.clicks('DisclosureTriangle', 'Joints');
  await studio.user.fills('slider', ARM, '80');
  await seesRobot(studio, ({ degrees }) => degrees.LEFT_SHOULDER_PITCH > 78);
}

async function saveScene(user, name) {
  await user.fills('textbox', 'Name of the scene', name);
  await user.clicks('button', 'Save');
  await user.readsValue('combobox', 'Saved scenes', name);
}

/** Waits until the button Undo says that it undoes a change. */
async function seesNext(user, change) {
  const undo = await user.finds('button', 'Undo');
  await user.until(() => undo.evaluate((button, text) => button.title.includes(text), change));
}

slow('a key lets the puppet walk while it is held', async (t) => {
  const studio = await openField(t);
  const { user, stage } = studio;
  await addPuppet(studio);
  const place = async () => (await stage.world()).robots[0].place.x;
  const start = await place();

  await user.page.keyboard.down('w');
  await user.until(async () => (await place()) > start + 0.3);
  await user.page.keyboard.up('w');

  await user.until(async () => {
    const [{ cycle }, before] = [await stage.world(), await place()];
    await user.until(async () => (await stage.world()).cycle > cycle + 50);
    return Math.abs((await place()) - before) < 0.005;
  });
});

slow('the joints of a new puppet are in reach', async (t) => {
  const studio = await openField(t);
  const { user } = studio;
  await addPuppet(studio);

  await user.clicks('DisclosureTriangle', 'Joints');

  const slider = await user.finds('slider', 'neck yaw');
  await user.until(() => slider.isIntersectingViewport({ threshold: 1 }));
});

slow('a button at the lower edge of the tools is clicked although there is more below', async (t) => {
  const { user } = await openField(t);
  const add = await user.finds('button', 'Add a puppet');
  const [x, y] = await add.evaluate((button) => {
    const tools = button.closest('#side');
    const { bottom } = tools.getBoundingClientRect();
    tools.scrollTop += button.getBoundingClientRect().bottom - bottom;
    const { left, width } = button.getBoundingClientRect();
    return [left + width / 2, bottom - 6];
  });
  await user.page.waitForSelector('#side[data-more]');

  await user.page.mouse.click(x, y);

  await user.sees('You are steering Puppets 1');
});

slow('agents join at the port that the hint names, and a reset frees the names of teams that have left', async (t) => {
  const studio = await openField(t);
  const { user } = studio;
  await user.sees(COMMAND);
  const [, port] = COMMAND.exec(await user.text());
  await addPuppet(studio);
  await user.clicks('button', 'Remove');
  await user.until(async () => (await studio.stage.world()).robots.length === 0);

  await user.clicks('button', 'Reset');
  await user.until(async () => !(await user.text()).includes('Puppets'));
  for (const team of ['Stars', 'Moons']) {
    join(t, port, { team });
    await user.sees(`${team} 1`);
  }
  await user.reads('region', 'Scoreboard', /Stars.*Moons/s);

  join(t, port, { team: 'Suns' });
  await user.sees('no room for team "Suns"');
});

slow('a scene is renamed, deleted and restored', async (t) => {
  const studio = await openField(t);
  const { user } = studio;
  const seesScene = (name) => user.readsValue('combobox', 'Saved scenes', name);
  await addPuppet(studio);
  await saveScene(user, 'Before the kick');

  await user.fills('textbox', 'Name of the scene', 'Free kick');
  await user.clicks('button', 'Rename');
  await seesScene('Free kick');
  await user.clicks('button', 'Delete');
  await seesScene('');
  await seesNext(user, 'scene "Free kick" deleted');
  await user.clicks('button', 'Undo');
  await seesScene('Free kick');
  await seesNext(user, 'renamed');
  await user.clicks('button', 'Undo');
  await seesScene('Before the kick');
  await user.clicks('button', 'Redo');

  await seesScene('Free kick');
});

slow('a slider moves an arm and a scene keeps it', async (t) => {
  const studio = await openField(t);
  const { user, stage } = studio;
  await addPuppet(studio);
  await raiseArm(studio);
  await saveScene(user, 'Arm up');
  await user.fills('slider', ARM, '0');
  await seesRobot(studio, ({ degrees }) => degrees.LEFT_SHOULDER_PITCH < 2);

  await user.clicks('button', 'Restore');

  await user.sees('The world was restored exactly.');
  await seesRobot(studio, ({ degrees }) => degrees.LEFT_SHOULDER_PITCH > 78);
  assert.ok((await stage.world()).isPaused);
});

slow('a puppet with a raised arm looks as it should', async (t) => {
  const studio = await openField(t, FOR_PICTURES);
  await addPuppet(studio);
  await raiseArm(studio);

  await studio.user.takesAPicture('studio-puppet');
});

slow('a recording continues from the shown moment', async (t) => {
  const studio = await openStudio(t, { speed: 2, room: 'replay/game', recordings: ['game'] });
  const { user, stage } = studio;
  await user.sees('of 4.18 s');

  await user.presses('End');
  await user.clicks('button', 'Start here');

  await user.sees('The world was restored only approximately');
  await seesRobot(studio, ({ place }) => place.z < 0.25);
  assert.ok((await stage.world()).isPaused);
  assert.match(user.page.url(), /#field$/);
  await user.reads('region', 'Scoreboard', /Ada\s*1\s*:\s*0/);
});

slow('a foul is shown beside the score', async (t) => {
  const { user, stage } = await openField(t, { robots: [{}, { side: 'RIGHT' }] });
  await user.finds('region', 'Scoreboard');

  await stage.callFoul();

  await user.reads('region', 'Scoreboard', 'Foul: Blue_Newbies 1 runs into an opponent');
});
