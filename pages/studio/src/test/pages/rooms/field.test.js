/** A student watches and steers the game on the pitch. */
import assert from 'node:assert/strict';
import { quick, slow } from '../tests.js';
import { openStudio } from '../user.js';

const TEAMMATE = { number: 1, x: -0.8, y: 0.3 };
const OPPONENT = { side: 'RIGHT', number: 5, x: 1, y: 0, heading: 180 };

/** Opens the Field room with robots and waits until all of them stand there. */
async function openField(t, robots = [TEAMMATE], options = {}) {
  const studio = await openStudio(t, { robots, ...options });
  await studio.user.page.waitForFunction((last) => studio.view.robots.poses[last]?.[2] > 0, {}, robots.length - 1);
  return studio;
}

const openTools = (user) => user.clicks('button', 'Tools ▾');

async function isPressed(user, name) {
  return (await user.finds('button', name)).evaluate((button) => button.ariaPressed === 'true');
}

/** Waits until the camera of a name is the chosen one. */
const seesCamera = (user, name) => user.until(() => isPressed(user, name));

async function centreOf(user, robot) {
  return user.pointOf(robot.x, robot.y, 0.35);
}

quick('a robot stands on the pitch and the ball is dragged with the mouse', async (t) => {
  const { user, stage } = await openField(t);

  await user.presses('3');
  await user.drags(await user.pointOf(0, 0, 0.04), await user.pointOf(0, -1, 0.04));

  await user.until(async () => Math.abs((await stage.world()).ball.y + 1) < 0.2);
  assert.ok(Math.abs((await stage.world()).ball.x) < 0.3);
});

slow('a single robot is followed by the camera', async (t) => {
  const { user } = await openField(t);

  await openTools(user);

  await seesCamera(user, 'Follow');
  await user.seesNo('Waiting for a robot');
  await user.page.waitForFunction(() => studio.view.robots.meshes.some((mesh) => mesh.visible));
});

slow('an empty pitch waits for a robot', async (t) => {
  const { user } = await openStudio(t);

  await user.sees('Waiting for a robot');
});

slow('the key N follows the next robot', async (t) => {
  const { user } = await openField(t, [TEAMMATE, OPPONENT]);

  await user.presses('n');

  await openTools(user);
  await seesCamera(user, 'Follow');
  await user.until(async () => {
    const [followed] = await centreOf(user, OPPONENT);
    const [other] = await centreOf(user, TEAMMATE);
    return Math.abs(followed - 683) < 200 && Math.abs(other - 683) > 300;
  });
});

slow('buttons pause, step and play', async (t) => {
  const { user, stage } = await openField(t);

  await user.clicks('button', '❚❚ Pause');
  await user.finds('button', '▶ Play');
  const { cycle, isPaused } = await stage.world();
  assert.ok(isPaused);
  await user.clicks('button', 'Step');
  await user.until(async () => (await stage.world()).cycle === cycle + 1);
  await user.clicks('button', '▶ Play');

  await user.until(async () => (await stage.world()).cycle > cycle + 5);
});

slow('keys pause, step and change the speed', async (t) => {
  const { user, stage } = await openField(t);

  await user.presses('Space');
  await user.until(async () => (await stage.world()).isPaused);
  const { cycle } = await stage.world();
  await user.presses(',');
  await user.until(async () => (await stage.world()).cycle === cycle + 10);
  await user.presses('+');
  await user.readsValue('combobox', 'Speed', '2');
  assert.equal((await stage.world()).speed, '2.0');
  await user.presses('-');

  await user.readsValue('combobox', 'Speed', '1');
  assert.equal((await stage.world()).speed, '1.0');
});

slow('the speed is chosen from the list', async (t) => {
  const { user, stage } = await openField(t);

  await user.fills('combobox', 'Speed', 'fastest');

  await user.until(async () => (await stage.world()).speed === 'Infinity');
});

slow('a reset brings the ball back', async (t) => {
  const { user, stage } = await openField(t);
  await stage.order({ do: 'placeBall', x: 2, y: 1, z: 0.042 });
  await user.until(async () => (await stage.world()).ball.x > 1.9);

  await user.clicks('button', 'Reset');

  await user.until(async () => Math.abs((await stage.world()).ball.x) < 0.1);
});

slow('the referee is controlled by button and list', async (t) => {
  const { user, stage } = await openField(t, [TEAMMATE, OPPONENT]);

  await openTools(user);
  await user.fills('combobox', 'Play mode', 'goal_kick_left');
  await user.until(async () => (await stage.world()).playMode === 'GOAL_KICK_LEFT');
  await user.clicks('button', 'Drop ball');

  await user.until(async () => (await stage.world()).playMode === 'PLAY_ON');
  await user.reads('region', 'Scoreboard', 'Play on');
});

slow('a robot is dragged with the mouse and remains upright', async (t) => {
  const { user, stage } = await openField(t);

  await user.presses('3');
  await user.drags(await centreOf(user, TEAMMATE), await user.pointOf(0.8, 0.3, 0.35));

  await user.until(async () => (await stage.world()).robots[0].place.x > 0.3);
  const { z } = (await stage.world()).robots[0].place;
  assert.ok(z > 0.3 && z < 0.45, `height ${z}`);
});

slow('keys choose the camera', async (t) => {
  const { user } = await openField(t);
  await openTools(user);

  for (const [key, name] of [
    ['1', 'Free'],
    ['2', 'Follow'],
    ['3', 'Top'],
    ['4', 'Robot’s eyes'],
  ]) {
    await user.presses(key);
    await seesCamera(user, name);
  }
});

slow('arrow keys turn the view', async (t) => {
  const { user } = await openField(t);
  await user.presses('1');
  const [before] = await user.pointOf(6, 0, 0);

  await user.presses('ArrowRight');

  await user.until(async () => Math.abs((await user.pointOf(6, 0, 0))[0] - before) > 5);
});

slow('real shadows can be switched on', async (t) => {
  const { user } = await openField(t);

  await openTools(user);
  await user.clicks('checkbox', 'Real shadows');

  await user.page.waitForFunction(() => {
    const { renderer, softShadows } = studio.view;
    return renderer.shadowMap.enabled && !softShadows.group.visible;
  });
});

slow('the page becomes dark and light again', async (t) => {
  const { user } = await openField(t);
  const colour = () => user.page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await colour();

  await user.clicks('button', 'Dark');
  await user.until(async () => (await colour()) !== light);
  await user.clicks('button', 'Light');

  await user.until(async () => (await colour()) === light);
});

slow('the page connects again when the simulator is restarted', async (t) => {
  const { user, stage } = await openField(t);
  user.expectsComplaints(/WebSocket|ERR_CONNECTION/);

  await stage.end();
  await user.sees('The simulator has ended');
  const restart = () => stage.restart({ robots: [{ number: 9, type: 1, x: 1, y: 1, heading: 180 }] });
  await user.until(() =>
    restart().then(
      () => true,
      () => false,
    ),
  );

  await user.sees('Blue_Newbies 9');
  await user.seesNo('The simulator has ended');
});

slow('22 robots of all types need at most a hundred draw calls', async (t) => {
  const robots = Array.from({ length: 22 }, (_, i) => ({
    side: i < 11 ? 'LEFT' : 'RIGHT',
    number: (i % 11) + 1,
    type: i % 5,
    x: -5 + 0.9 * (i % 11),
    y: i < 11 ? -1.5 : 1.5,
    heading: 90,
  }));
  const { user } = await openField(t, robots);
  const drawCalls = () => user.page.evaluate(() => studio.view.drawCalls);
  const calls = await drawCalls();

  await openTools(user);
  await user.clicks('checkbox', 'Real shadows');
  await user.page.waitForFunction(() => studio.view.renderer.shadowMap.enabled && !studio.session.stale);

  assert.ok(calls >= 6 && calls <= 20, `${calls} draw calls without shadows`);
  assert.ok((await drawCalls()) <= 100, `${await drawCalls()} draw calls with shadows`);
});
