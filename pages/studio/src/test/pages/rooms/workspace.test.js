/** The layout of picture and panels is changed by mouse, keys and a menu, and the browser remembers it. */
import assert from 'node:assert/strict';
import { slow } from '../tests.js';
import { openStudio } from '../user.js';

const PICTURE = 'The pitch in three dimensions. Arrow keys turn the view.';
const EDGE = 'Edge right of Picture';

async function openRobot(t, options = {}) {
  const studio = await openStudio(t, { room: 'robot', robots: [{}], width: 1440, height: 900, ...options });
  await studio.user.reads('region', 'Joints', 'Knee pitch');
  return studio;
}

async function boxOf(user, role, name) {
  return (await user.finds(role, name)).boundingBox();
}

const pictureWidth = async (user) => (await boxOf(user, 'application', PICTURE)).width;

/** Waits until the picture has a width, to a few pixels. */
function seesWidth(user, width, tolerance = 3) {
  return user.until(async () => Math.abs((await pictureWidth(user)) - width) < tolerance);
}

slow('an edge is dragged and keeps its position', async (t) => {
  const { user, visit } = await openRobot(t);
  const before = await pictureWidth(user);
  const { x, width } = await boxOf(user, 'separator', EDGE);

  await user.drags([x + width / 2, 300], [x + width / 2 + 120, 300]);

  await seesWidth(user, before + 120, 6);
  const after = await pictureWidth(user);
  await visit();
  await user.finds('separator', EDGE);
  await seesWidth(user, after);
});

slow('an edge is moved by arrow keys and a double click puts it back', async (t) => {
  const { user } = await openRobot(t);
  const before = await pictureWidth(user);
  const edge = await user.finds('separator', EDGE);
  const percent = () => edge.evaluate((separator) => Number(separator.ariaValueNow));
  const percentBefore = await percent();

  await edge.focus();
  await user.presses('ArrowLeft', 'ArrowLeft');

  await user.until(async () => (await pictureWidth(user)) < before - 60);
  assert.ok((await percent()) < percentBefore);
  await edge.click({ count: 2 });
  await seesWidth(user, before);
});

slow('a menu shows and hides the panels of a room', async (t) => {
  const { user, visit } = await openRobot(t);

  await user.clicks('button', 'Panels');
  const joints = await user.finds('checkbox', 'Joints');
  assert.ok(await joints.evaluate((box) => box.checked));
  await user.clicks('checkbox', 'Joints');

  await user.findsNo('region', 'Joints');
  await visit();
  await user.finds('region', 'Curves');
  await user.findsNo('region', 'Joints');
  await user.clicks('button', 'Panels');
  const menu = await user.finds('group', 'Panels');
  await (await menu.$('button')).click();
  await user.finds('region', 'Joints');
});

slow('a panel of the robot is added to the field', async (t) => {
  const { user } = await openStudio(t, { robots: [{}], width: 1440, height: 900 });
  await seesWidth(user, 1440, 1);

  await user.clicks('button', 'Panels');
  await user.clicks('checkbox', 'Curves');

  await user.finds('region', 'Curves');
  await user.finds('button', 'Remove this plot');
  await user.until(async () => (await pictureWidth(user)) < 1240);
  assert.match(user.page.url(), /#field$/);
});

slow('the robot that is chosen in the picture is the one in the panels', async (t) => {
  const robots = [{}, { side: 'RIGHT', number: 4, x: 1, y: 1, heading: 180 }];
  const { user } = await openRobot(t, { robots });
  await user.readsValue('combobox', 'Robot', '0');

  await user.page.mouse.click(...(await user.pointOf(1, 1, 0.35)));
  await user.readsValue('combobox', 'Robot', '1');
  await user.page.keyboard.press('n');

  await user.readsValue('combobox', 'Robot', '0');
});

slow('tools over the picture are folded until they are needed', async (t) => {
  const { user, visit } = await openStudio(t, { robots: [{}], width: 1440, height: 900 });
  const tools = await user.finds('button', 'Tools ▾');
  await user.findsNo('region', 'Game');
  assert.equal(await tools.evaluate((button) => button.ariaExpanded), 'false');

  await user.clicks('button', 'Tools ▾');

  await user.finds('region', 'Game');
  await visit();
  await user.finds('region', 'Game');
});
