/** The field of the web edition: changes of the world can be undone, scenes are stored, and robots are steered by hand. */
import { quick } from '../tests.js';
import { openWebEdition } from '../user.js';

const SHOULDER = 'left shoulder pitch';

/** Opens the field with a robot that plays, without a server from then on. */
async function openField(t) {
  const page = await openWebEdition(t);
  await page.user.sees(/cycle \d{3}/);
  await page.user.page.evaluate(async () => void (await navigator.serviceWorker.ready));
  await page.server.close();
  return page;
}

/** Returns ball `{x, y}`, place of the first robot `{x, y}`, and all numbers of both as a text. */
const world = (user) =>
  user.page.evaluate(() => {
    const { ball, robots } = studio.state.frame;
    const [x, y] = robots[0].torso;
    return {
      ball: { x: ball[0], y: ball[1] },
      robot: { x, y },
      all: [...ball, ...robots[0].torso, ...robots[0].degrees].join(),
    };
  });

const ballIsAt = (user, x, y, within = 0.01) =>
  user.until(
    async () => {
      const { ball } = await world(user);
      return Math.hypot(ball.x - x, ball.y - y) < within;
    },
    () => `has the ball at ${x}, ${y}`,
  );

async function undoes(user, what) {
  await user.until(async () =>
    (await (await user.finds('button', 'Undo')).evaluate(({ title }) => title)).includes(`Undo: ${what} `),
  );
  await user.clicks('button', 'Undo');
}

/** Opens the tools, which are complete once the robot has drawn something. */
async function opensTools(user) {
  await user.clicks('button', 'Tools ▾');
  await user.finds('checkbox', 'Drawings');
}

async function pauses(user) {
  await user.clicks('button', '❚❚ Pause');
  await user.finds('button', '▶ Play');
}

/** Moves the ball to these positions in one drag, which is one step for Undo. */
async function movesTheBall(user, ...places) {
  for (const [x, y] of places) {
    await user.page.evaluate(
      (...at) => studio.send({ do: 'placeBall', gesture: 7, x: at[0], y: at[1], z: 0.042 }),
      x,
      y,
    );
  }
  await ballIsAt(user, ...places.at(-1));
}

quick('ball and robot that were moved are back to the bit', async (t) => {
  const { user } = await openField(t);
  await pauses(user);
  const before = await world(user);

  await movesTheBall(user, [1, 1], [2, 1], [3, 1], [4, 1], [5, 1]);
  const robot = { side: 'left', number: 1, x: -2, y: 1.5, z: 0.4, headingDegrees: 90 };
  await user.page.evaluate((place) => studio.send({ do: 'placeRobot', ...place }), robot);
  await user.until(async () => Math.abs((await world(user)).robot.y - 1.5) < 0.1);

  await undoes(user, 'robot moved');
  await user.sees('Undone: robot moved.');
  await user.presses('Control+z');
  await user.sees('Undone: ball moved.');
  await user.until(async () => (await world(user)).all === before.all);
  await user.clicks('button', 'Redo');
  await user.sees('Redone: ball moved.');
  await ballIsAt(user, 5, 1);
});

quick('a scene survives a reload and is restored exactly', async (t) => {
  const { user, visit } = await openField(t);
  await pauses(user);
  await movesTheBall(user, [1, 1]);
  const before = await world(user);
  await opensTools(user);
  await user.fills('textbox', 'Name of the scene', 'Corner');
  await user.clicks('button', 'Save');
  await user.readsValue('combobox', 'Saved scenes', 'Corner');

  await visit();
  await user.finds('checkbox', 'Drawings');
  await user.readsValue('combobox', 'Saved scenes', 'Corner');
  await user.clicks('button', 'Restore');

  await user.sees('The world was restored exactly. Agents are not restored: they keep what they remember.');
  await user.until(async () => (await world(user)).all === before.all);
  await user.finds('button', '▶ Play');
  await undoes(user, 'scene loaded');
});

quick('a scene is renamed, deleted and restored', async (t) => {
  const { user } = await openField(t);
  await opensTools(user);
  await user.fills('textbox', 'Name of the scene', 'Before the kick');
  await user.clicks('button', 'Save');
  await user.readsValue('combobox', 'Saved scenes', 'Before the kick');

  await user.fills('textbox', 'Name of the scene', 'Free kick');
  await user.clicks('button', 'Rename');
  await user.readsValue('combobox', 'Saved scenes', 'Free kick');
  await user.clicks('button', 'Delete');
  await user.readsValue('combobox', 'Saved scenes', '');

  await user.clicks('button', 'Undo');
  await user.readsValue('combobox', 'Saved scenes', 'Free kick');
  await user.clicks('button', 'Undo');
  await user.readsValue('combobox', 'Saved scenes', 'Before the kick');
});

quick('the world continues from the shown cycle of its recording', async (t) => {
  const { user } = await openField(t);
  await movesTheBall(user, [3, 2]);
  await user.clicks('link', 'Replay');
  await user.page.locator('[data-recording] .open').click(); // its name tells the growing duration
  await user.seesNo('Choose a recording.');

  await user.presses('Home');
  await user.clicks('button', 'Start here');

  await user.sees('The world was restored only approximately');
  await user.finds('button', '▶ Play');
  await ballIsAt(user, 0, 0);
  await user.clicks('button', 'Undo');
  await ballIsAt(user, 3, 2, 0.3);
});

quick('a puppet is steered by sliders and keys, and removed', async (t) => {
  const { user } = await openField(t);
  await opensTools(user);
  await user.clicks('button', 'Add a puppet');
  await user.sees('You are steering');

  await user.clicks('DisclosureTriangle', 'Joints');
  await user.fills('slider', SHOULDER, '80');
  await user.sees(/left shoulder pitch\s+(79|80|81)°/);
  await user.page.keyboard.down('w');
  await user.seesNo(/left shoulder pitch\s+([6-9]\d|1\d\d)°/);
  await user.page.keyboard.up('w');
  await user.clicks('button', 'Remove');
  await user.seesNo('You are steering');

  await undoes(user, 'puppet removed');
  await user.sees('Undone: puppet removed.');
  await user.sees('Click a puppet to steer it.');
});
