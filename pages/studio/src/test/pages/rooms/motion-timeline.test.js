/** The timeline of the Motion room with mouse and keys: rows and curves of joints, several keyframes at once, marks, balance, trials. */
import assert from 'node:assert/strict';
import { slow } from '../tests.js';
import {
  fileOf,
  keyframesIn,
  openMotion,
  readsAngle,
  saves,
  seesKeyframes,
  STANDING,
  takesBack,
  turns,
} from './motion-room.js';

const TIMELINE = 'Timeline. The left and right arrow keys select a keyframe.';
const [LEFT_SHOULDER_PITCH, LEFT_SHOULDER_YAW] = [3, 4]; // the first number of a line is the time

/** Five keyframes, 400 ms apart, whose neck yaw is 0, 10, 20, 30 and 40. */
const FIVE = [0, 10, 20, 30, 40].map((yaw) => `400 ${yaw}${STANDING.slice(1)}\n`).join('');

async function openFive(t) {
  const studio = await openMotion(t, { width: 1024, files: { mine: FIVE } });
  await studio.user.page.waitForSelector('.mark');
  return studio;
}

const focusTimeline = async (user) => (await user.finds('region', TIMELINE)).focus();

/** Returns the point of the page at which the timeline shows a time in milliseconds in the row of a joint. */
function cell(user, millis, joint = 'neck yaw') {
  const place = (time, name) => {
    const middle = (box) => [box.x + box.width / 2, box.y + box.height / 2];
    const keyframes = [...document.querySelectorAll('[data-keyframe]')].map((keyframe) => ({
      at: 1000 * Number(/at ([0-9.]+) s/.exec(keyframe.getAttribute('aria-label'))[1]),
      x: middle(keyframe.querySelector('.diamond').getBoundingClientRect())[0],
    }));
    const [first, last] = [keyframes.at(0), keyframes.at(-1)];
    const row = [...document.querySelectorAll('.track-name')].find((each) => each.textContent.startsWith(name));
    const x = first.x + ((time - first.at) / (last.at - first.at)) * (last.x - first.x);
    return [x, middle(row.getBoundingClientRect())[1]];
  };
  return user.page.evaluate(place, millis, joint);
}

const dragsKeyframe = async (user, from, to, ...keys) =>
  user.drags(await cell(user, from, 'left shoulder yaw'), await cell(user, to, 'left shoulder yaw'), ...keys);

/** Returns the middles of the points of the shown curve. */
const pointsOfCurve = ({ page }) =>
  page.$$eval('.track-drawing .point', (points) =>
    points.map((point) => {
      const { x, y, width, height } = point.getBoundingClientRect();
      return [x + width / 2, y + height / 2];
    }),
  );

/** Returns whether a mark says that the robot tips over at the first keyframe. */
async function tipsOverAtFirst(user) {
  const [end] = await cell(user, 500);
  const marks = await user.page.$$eval('.mark.balance', (all) => all.map((mark) => mark.getBoundingClientRect().x));
  return marks.some((x) => x < end);
}

/** Makes the robot tip over at the first keyframe, and bends it so far at the last one that it cannot be balanced there. */
async function unbalances(user) {
  const turnsBoth = async (joint, degrees) => {
    await turns(user, `left ${joint}`, degrees);
    await turns(user, `right ${joint}`, degrees);
  };
  await turnsBoth('foot pitch', '4');
  await focusTimeline(user);
  await user.presses('End');
  await turnsBoth('hip pitch', '100');
  await turnsBoth('foot pitch', '75');
  await user.until(() => tipsOverAtFirst(user));
}

const isShankColoured = ({ page }) =>
  page.evaluate(() => {
    const { body, stage } = studio.motion;
    return stage.paint.shapes[body.model.links.findIndex(({ name }) => name === 'lshank')].visible;
  });

const seesGhosts = (user) => user.until(() => user.page.evaluate(() => studio.motion.stage.ghosts.group.visible));

/** Goes to the field of a joint by Tab and types an angle. */
async function tabsAndTypes(user, joint, degrees) {
  await tabsTo(user, 'textbox', `${joint} in degrees`);
  await user.types(degrees);
}

/** Presses Tab until what has this role and name has the focus. */
async function tabsTo(user, role, name) {
  const target = await user.finds(role, name);
  const isThere = () => target.evaluate((element) => element === document.activeElement);
  for (let i = 0; !(await isThere()); i++) {
    assert.ok(i < 400, `Tab does not reach ${role} "${name}"`);
    await user.presses('Tab');
  }
}

slow('keyframes in a box are moved by keys and come back step by step', async (t) => {
  const studio = await openFive(t);
  const { user } = studio;
  await user.drags(await cell(user, 600), await cell(user, 1400, 'neck pitch'));
  await user.sees(/^2 joints in 2 keyframes selected/m);
  await focusTimeline(user);

  await user.presses('Control+ArrowRight');
  await seesKeyframes(user, 400, 820, 1220, 1620, 2020);
  await user.presses('Alt+Shift+ArrowLeft');
  await seesKeyframes(user, 400, 720, 1120, 1620, 2020);
  await user.presses('Control+Shift+ArrowUp');
  assert.deepEqual(
    (await saves(studio)).map(([, yaw]) => yaw),
    [0, 20, 30, 30, 40],
  );

  await focusTimeline(user);
  await user.presses('Control+z', 'Control+z');
  await seesKeyframes(user, 400, 820, 1220, 1620, 2020);
  await takesBack(user, 1);
  await seesKeyframes(user, 400, 800, 1200, 1600, 2000);
});

slow('rows stay under the mouse until it lets go when a mark comes', async (t) => {
  const { user } = await openFive(t);
  const { mouse } = user.page;
  const top = async () => (await (await user.page.$('.track-drawing')).boundingBox()).y;
  const before = await top();

  await mouse.move(...(await cell(user, 2000, 'left shoulder yaw')));
  const end = await cell(user, 1620, 'left shoulder yaw');
  await mouse.down();
  await mouse.move(...end, { steps: 2 });
  await user.sees('its motor needs');
  assert.equal(await top(), before);
  await mouse.up();

  await user.sees(/^too fast \d/m);
  await user.until(async () => (await top()) > before);
});

slow('a keyframe is dragged alone while Alt is held or the switch is on', async (t) => {
  const { user } = await openFive(t);

  await dragsKeyframe(user, 800, 900, 'Alt');
  await seesKeyframes(user, 400, 900, 1200, 1600, 2000);
  await user.clicks('checkbox', 'Move alone');
  await dragsKeyframe(user, 900, 800);
  await seesKeyframes(user, 400, 800, 1200, 1600, 2000);
  await user.clicks('checkbox', 'Move alone');
  await dragsKeyframe(user, 800, 900);

  await seesKeyframes(user, 400, 900, 1300, 1700, 2100);
  await takesBack(user, 3);
});

slow('a point of a curve is dragged to another angle', async (t) => {
  const studio = await openFive(t);
  const { user } = studio;
  await user.clicks('button', 'Curves');
  await user.until(async () => (await pointsOfCurve(user)).length === 5);
  const [, [x, y], [, y20], [, y30]] = await pointsOfCurve(user);

  await user.drags([x, y], [x + 2, (y20 + y30) / 2]);

  const keyframes = await saves(studio);
  assert.ok(Math.abs(keyframes[1][1] - 25) < 1, `${keyframes[1][1]}°, not 25°`);
  assert.deepEqual(
    keyframes.map(([millis]) => millis),
    [400, 400, 400, 400, 400],
  );
  await takesBack(user, 1);
});

slow('the wheel zooms at the mouse, and 0 shows the whole motion', async (t) => {
  const { user } = await openFive(t);
  const third = async () => (await user.finds('image', 'Keyframe 3 at 1.20 s')).boundingBox();
  const before = await third();
  await user.page.mouse.move(before.x + before.width / 2, before.y + 10);

  await user.page.mouse.wheel({ deltaY: -500 });

  await user.findsNo('image', 'Keyframe 5 at 2.00 s');
  const after = await third();
  assert.ok(Math.abs(after.x - before.x) < 2, `${before.x}, then ${after.x}`);
  await focusTimeline(user);
  await user.presses('End');
  await user.finds('image', 'Keyframe 5 at 2.00 s');
  await user.sees('2.00 s of 2.00 s');
  await user.presses('0');
  await seesKeyframes(user, 400, 800, 1200, 1600, 2000);
});

slow('a click on a mark goes to it and shows the problem', async (t) => {
  const { user } = await openFive(t);
  await focusTimeline(user);
  await user.presses('End');
  await turns(user, 'left knee pitch', '-140');
  await user.page.waitForSelector('.mark.range');
  const hint = 'left knee pitch at -140° is beyond -130° to 1°. Click to go there.';
  assert.equal(await user.page.$eval('.mark.range', (mark) => mark.textContent), hint);
  await focusTimeline(user);
  await user.presses('Home');
  await user.sees('0.40 s of 2.00 s');

  const { x, y } = await (await user.page.$('.mark.range')).boundingBox();
  await user.page.mouse.click(x + 3, y + 3);

  await user.sees('2.00 s of 2.00 s');
  await user.sees('-140° is beyond');
  await user.until(() => user.page.$eval('#motion-joints .chosen [data-joint]', (field) => field.value === '-140'));
  await focusTimeline(user);
  await user.presses('Home', 'w');
  await user.sees(/^(1\.[5-9]|2\.0)\d s of 2\.00 s$/m);
});

slow('a motion is made balanced in one step, which says where that is not possible', async (t) => {
  const { user } = await openFive(t);
  await unbalances(user);

  await user.clicks('button', 'Motion ▾');
  await user.clicks('button', 'Balance');
  await user.finds('dialog', 'Balance');
  await user.sees(/^Keyframe 5: /m);
  await user.page.locator('::-p-aria([role="dialog"]) ::-p-text(Keyframe 5: )').click();
  await user.findsNo('dialog', 'Balance');
  await user.sees('2.00 s of 2.00 s');
  await user.until(async () => !(await tipsOverAtFirst(user)));

  await user.clicks('button', '↶ Undo');
  await focusTimeline(user);
  await user.presses('Home');
  await readsAngle(user, 'left foot pitch', '4');
  await takesBack(user, 6);
});

slow('the picture colours the limb that cannot follow and says why', async (t) => {
  const { user } = await openFive(t);
  const why = /^left knee pitch at -140° is beyond -130° to 1°$/m;

  await turns(user, 'left knee pitch', '-140');

  await user.sees(why);
  await user.until(() => isShankColoured(user));
  await user.clicks('button', '↶ Undo');
  await user.seesNo(why);
  await user.until(async () => !(await isShankColoured(user)));
});

slow('a trial shows where the robot is behind the plan', async (t) => {
  const { user } = await openFive(t);
  const { page } = user;
  await turns(user, 'left shoulder pitch', '60');

  await user.clicks('button', 'Try with physics');

  await user.sees('Largest lag behind the plan: left shoulder pitch');
  await page.waitForSelector('.track-drawing .late');
  await user.clicks('button', 'Curves');
  await page.locator('.track-names ::-p-text(left shoulder pitch)').click();
  await page.waitForSelector('.track-drawing .reached');
  const watching = await user.finds('checkbox', 'With physics');
  assert.ok(await watching.evaluate((box) => box.checked));
  await seesGhosts(user);
  await user.clicks('checkbox', 'With physics');
  await user.until(() => watching.evaluate((box) => !box.checked));
  await seesGhosts(user);
});

slow('the keyboard alone makes a new motion, saves it and plays it', async (t) => {
  const studio = await openFive(t);
  const { user } = studio;
  await tabsTo(user, 'button', '+ New');
  await user.presses('Enter');
  await seesKeyframes(user, 500);
  await tabsAndTypes(user, 'left shoulder pitch', '60');
  await tabsTo(user, 'slider', 'left shoulder yaw');
  await user.presses('i');
  await seesKeyframes(user, 500, 1000);
  await tabsAndTypes(user, 'left shoulder yaw', '75');
  await tabsTo(user, 'region', TIMELINE);
  await user.presses('Control+Shift+ArrowRight');
  await seesKeyframes(user, 500, 1100);
  await user.presses('Control+s');
  await user.finds('textbox', 'Name');
  await user.types('keys-only');
  await user.presses('Enter');
  await user.sees('Saved.');
  await user.presses(' ');
  await user.sees('❚❚ Pause');
  await user.sees('▶ Play');
  await user.sees('1.10 s of 1.10 s');

  const [first, second] = keyframesIn(await fileOf(studio, 'keys-only'));
  assert.deepEqual([first[0] + second[0], first[LEFT_SHOULDER_PITCH], second[LEFT_SHOULDER_YAW]], [1100, 60, 75]);
});

slow('the bars take one row each on a small screen', async (t) => {
  const { user } = await openFive(t);
  for (const name of ['Motion', 'Play and try']) {
    const bar = await user.finds('region', name);
    const [height, width] = await bar.evaluate(({ clientHeight, scrollWidth }) => [clientHeight, scrollWidth]);
    assert.ok(height < 48, `${name} is ${height} pixels high`);
    assert.equal(width, 1024);
  }

  await user.clicks('button', 'Keyframes ▾');
  await user.clicks('button', 'Duplicate');

  await seesKeyframes(user, 400, 800, 1200, 1600, 2000, 2400);
  await user.findsNo('button', 'Duplicate');
});
