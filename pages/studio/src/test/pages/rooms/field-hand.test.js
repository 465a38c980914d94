/** Names and trail in the picture of the pitch, and robots and ball that are moved by the mouse. */
import assert from 'node:assert/strict';
import { slow } from '../tests.js';
import { openStudio } from '../user.js';

const ROBOTS = [
  { number: 1, x: -1, y: 0.5 },
  { side: 'RIGHT', number: 7, x: 2, y: 1, heading: 180 },
];

async function openField(t) {
  const studio = await openStudio(t, { robots: ROBOTS, width: 1440, height: 900 });
  await studio.user.sees('Orange_Rockets 7');
  return studio;
}

const openTools = (user) => user.clicks('button', 'Tools ▾');

/** Returns the radius in metres of the ring around the ball or the first robot. */
const ringOf = (user, kind) =>
  user.page.evaluate((each) => studio.pointer.pointing.radiusOf({ kind: each, robot: 0 }), kind);

/** Moves the mouse to a point of the pitch. */
async function pointsAt(user, ...place) {
  await user.page.mouse.move(...(await user.pointOf(...place)));
}

slow('names stand above the robots until they are switched off', async (t) => {
  const { user, visit } = await openField(t);
  await user.sees('Blue_Newbies 1');
  const tag = await (await user.page.$('.name-tag')).boundingBox();
  const [x, y] = await user.pointOf(-1, 0.5, 0.6);
  assert.ok(Math.abs(tag.x + tag.width / 2 - x) < 8 && tag.y < y);

  await openTools(user);
  await user.clicks('checkbox', 'Names');

  await user.seesNo('Orange_Rockets 7');
  await visit();
  const names = await user.finds('checkbox', 'Names');
  assert.equal(await names.evaluate((box) => box.checked), false);
  await user.seesNo('Orange_Rockets 7');
});

slow('a robot is turned by its ring', async (t) => {
  const { user, stage } = await openField(t);

  await pointsAt(user, -1, 0.5, 0.35);
  await user.sees('drag its ring to turn it');
  await pointsAt(user, -1 + (await ringOf(user, 'robot')), 0.5, 0);
  await user.sees('Drag around the robot to turn it');
  await user.drags(await user.pointOf(-1 + (await ringOf(user, 'robot')), 0.5, 0), await user.pointOf(-1, 2.5, 0));

  await user.until(async () => Math.abs((await stage.world()).robots[0].heading - 90) < 8);
  assert.ok(Math.abs((await stage.world()).robots[0].place.x + 1) < 0.1);
});

slow('the ball is thrown by its ring and leaves a trail', async (t) => {
  const { user, stage } = await openField(t);

  await pointsAt(user, 0, 0, 0.04);
  await user.sees('drag its ring to throw it');
  await pointsAt(user, 0, -(await ringOf(user, 'ball')), 0);
  await user.sees('Pull to throw the ball');
  await user.drags(await user.pointOf(0, -(await ringOf(user, 'ball')), 0), await user.pointOf(0, -1.5, 0));

  await user.until(async () => (await stage.world()).ball.y < -1);
  await user.page.waitForFunction(() => {
    const { dots } = studio.view.trail;
    return dots.visible && dots.geometry.drawRange.count > 5;
  });
  await openTools(user);
  await user.clicks('checkbox', 'Trail of the ball');
  await user.page.waitForFunction(() => !studio.view.trail.dots.visible);
});

slow('the key Ctrl throws the ball without aiming at the ring', async (t) => {
  const { user, stage } = await openField(t);

  await user.drags(await user.pointOf(0, 0, 0.04), await user.pointOf(-2, 0, 0), 'Control');

  await user.until(async () => (await stage.world()).ball.x < -0.6);
});

slow('the camera follows the ball and a goal is shown again', async (t) => {
  const { user, stage } = await openField(t);

  await user.presses('5');
  await stage.order({ do: 'placeBall', x: 3, y: -2, z: 0.042 });
  await user.page.waitForFunction(() => {
    const [x, y] = studio.camera.shown.target;
    return studio.camera.mode === 'ball' && Math.hypot(x - 3, y + 2) < 0.1;
  });
  await openTools(user);
  await user.clicks('checkbox', 'Replay goals');
  await stage.order({ do: 'placeBall', x: 5.5, y: 0, z: 0.042 });
  await stage.order({ do: 'throwBall', x: 4, y: 0, z: 0 });

  await user.sees('Goal replay at half speed');
  await user.seesNo('Goal replay at half speed');
  const live = await user.finds('button', 'Live');
  await user.until(() => live.evaluate((button) => button.ariaPressed === 'true'));
});

slow('the help on keys explains the rings', async (t) => {
  const { user } = await openField(t);

  await user.presses('?');

  await user.reads('dialog', 'Keys and mouse', /Pull the ball’s ring.*throw the ball/s);
});
