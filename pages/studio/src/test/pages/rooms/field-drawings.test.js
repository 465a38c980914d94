/** What robots draw lies on the ground of the pitch, in layers that the user can switch. */
import assert from 'node:assert/strict';
import { slow } from '../tests.js';
import { openStudio } from '../user.js';

const BLUE = ['Blue_Newbies', '1'];
const ORANGE = ['Orange_Rockets', '2'];
const ROBOTS = [
  { number: 1, x: -2, y: -1, heading: 90 },
  { side: 'RIGHT', number: 2, type: 4, x: 2, y: -1, heading: 180 },
];
const CIRCLE_CORNERS = 48 * 6;
const LINE_CORNERS = 6;
const POINT_CORNERS = 16 * 6;

/** Opens the Field room with two robots in a world that stands still. */
async function openField(t, options = {}) {
  const studio = await openStudio(t, { robots: ROBOTS, isPaused: true, width: 1440, height: 900, ...options });
  await studio.user.sees('Orange_Rockets 2');
  return studio;
}

/** Returns the corners of all triangles, and the texts, that the picture has. */
function drawnBy(user) {
  return user.page.evaluate(() => {
    const { shapes, texts, group } = studio.view.drawings;
    const corners = group.visible ? shapes.geometry.getAttribute('position').count : 0;
    return { corners, texts: texts.children.map(({ name }) => name) };
  });
}

const hasCorners = async (user, count) => (await drawnBy(user)).corners === count;

/** Lets a robot draw. */
async function draw(stage, robot, ...drawing) {
  await stage.tell('draw', (await stage.world()).cycle / 50, ...robot, ...drawing);
}

/** Lets both robots draw, until the picture has come. */
function drawBoth({ user, stage }) {
  return user.until(async () => {
    await draw(stage, BLUE, 'circle', 'cyan', 2, 0, -0.5, 0.5, 'text', 'yellow', 2, 0, -0.5, 'ball');
    await draw(stage, ORANGE, 'line', '#f0f', 1, 0, 0, 1, 1, 0);
    return hasCorners(user, CIRCLE_CORNERS + LINE_CORNERS);
  });
}

async function isCyanAround(user, point) {
  const colours = await user.coloursAround(point, 4);
  return colours.some(([red, green, blue]) => Math.min(green, blue) > red + 90);
}

slow('drawings lie on the ground where the robot means them', async (t) => {
  const studio = await openField(t, { isSharp: true });
  const { user, stage } = studio;
  await drawBoth(studio);

  await user.presses('3');

  const { x, y } = (await stage.world()).robots[0].place;
  const [left, top] = await user.pointOf(x + 0.5, y + 2, 0.012);
  await user.until(() => isCyanAround(user, [left, top]));
  assert.equal(await isCyanAround(user, [left + 40, top + 40]), false);
  assert.deepEqual((await drawnBy(user)).texts, ['ball']);
});

slow('layers are switched and remembered', async (t) => {
  const studio = await openField(t);
  const { user, stage, visit } = studio;
  await user.clicks('button', 'Tools ▾');
  await user.findsNo('region', 'Drawings');
  await drawBoth(studio);

  await user.clicks('DisclosureTriangle', 'Layers');
  await user.reads('region', 'Drawings', 'Orange_Rockets 2');
  await user.clicks('checkbox', 'Circles');
  await user.until(() => hasCorners(user, LINE_CORNERS));
  assert.deepEqual((await drawnBy(user)).texts, ['ball']);
  await user.clicks('checkbox', 'Blue_Newbies 1');
  await user.until(async () => (await drawnBy(user)).texts.length === 0);

  await visit();
  await user.until(async () => {
    await draw(stage, ORANGE, 'point', 'no colour', 0, 0, 0);
    await draw(stage, BLUE, 'point', 'red', 0, 0, 0);
    return hasCorners(user, POINT_CORNERS);
  });
  await user.presses('d');
  await user.until(() => hasCorners(user, 0));
  const drawings = await user.finds('checkbox', 'Drawings');
  assert.equal(await drawings.evaluate((box) => box.checked), false);
});

slow('drawings vanish when the robot draws no more', async (t) => {
  const studio = await openField(t);
  await drawBoth(studio);

  await studio.stage.order({ do: 'resume' });

  await studio.user.until(() => hasCorners(studio.user, 0));
});
