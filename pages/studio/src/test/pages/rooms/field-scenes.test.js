/** The robots and landscapes of the documentation are seen on the pitch, in their colours. */
import assert from 'node:assert/strict';
import { folderWith, startJava } from '../stage.js';
import { picture } from '../tests.js';
import { FOR_PICTURES, newUser, openStudio } from '../user.js';

/** Look of a studio in which colours are seen; pictures have real shadows, too. */
const SHARP = { isSharp: true, quality: FOR_PICTURES.quality && `${FOR_PICTURES.quality}&shadows=on` };
/** Place where landscapes are. */
const LANDSCAPE = [-2.9, 0, 0.1];
const LOW_ARM = {
  LEFT_SHOULDER_PITCH: -78,
  LEFT_SHOULDER_YAW: 12,
  LEFT_ARM_ROLL: -85,
  LEFT_ARM_YAW: -38,
};
const LEGS = {
  LEFT_HIP_PITCH: 30,
  RIGHT_HIP_PITCH: 30,
  LEFT_KNEE_PITCH: -58,
  RIGHT_KNEE_PITCH: -58,
  LEFT_FOOT_PITCH: 28,
  RIGHT_FOOT_PITCH: 28,
};
const RAISED_ARM = {
  RIGHT_SHOULDER_PITCH: 40,
  RIGHT_SHOULDER_YAW: -25,
  RIGHT_ARM_ROLL: 60,
  RIGHT_ARM_YAW: 60,
};
const GREETING = { ...LOW_ARM, ...RAISED_ARM, ...LEGS, NECK_YAW: -12 };

const isGrass = ([red, green, blue]) => green > red + 40 && green > blue + 40;
const isBlue = ([red, green, blue]) => blue > red + 110 && blue > green + 50;
const isOrange = ([red, green, blue]) => red > blue + 120 && red > green + 50;
const isDark = ([red, green, blue]) => red + green + blue < 180;
const isCardboard = ([red, green, blue]) => red > 90 && red > blue + 60 && red > green + 15;
const isGrey = ([red, green, blue]) =>
  red > 70 && red < 215 && Math.abs(red - green) < 20 && Math.abs(green - blue) < 25;

/** Opens the Field room with a paused world. */
async function openScene(t, ball, { cycles, ...options }) {
  const { user, stage } = await openStudio(t, { isPaused: true, ...SHARP, ...options });
  const { cycle } = await stage.world();
  await stage.order({ do: 'placeBall', ...ball, z: 0.042 });
  await stage.order({ do: 'step', cycles });
  await user.until(async () => (await stage.world()).cycle >= cycle + cycles);
  await user.presses('1');
  return user;
}

/** Fails unless at least a share of the pixels around a point of the pitch has a colour. */
async function assertSeen(user, place, pixels, isColour, share) {
  const colours = await user.coloursAround(await user.pointOf(...place), pixels);
  const found = colours.filter(isColour).length / colours.length;
  assert.ok(found >= share, `${isColour.name} holds for ${found} of the pixels at ${place}`);
}

picture('a robot greets beside one of the other team', async (t) => {
  const robots = [
    { x: -3.42, y: 0.1, heading: -4, posture: GREETING },
    { side: 'RIGHT', number: 7, x: -4.7, y: 1.45, heading: -60 },
  ];
  const user = await openScene(t, { x: -3, y: -0.16 }, { robots, cycles: 150, width: 1280, height: 720 });
  await user.clicks('button', 'Got it');

  await user.looks({ target: [-3.3, 0.12, 0.27], azimuthDegrees: -29, elevationDegrees: 9.5, distance: 1.68 });

  await user.takesAPicture('studio-field');
  await assertSeen(user, [-3.42, 0.1, 0.1], 80, isBlue, 0.05);
  await assertSeen(user, [-3.42, 0.1, 0.3], 150, isDark, 0.02);
  await assertSeen(user, [-4.7, 1.45, 0.3], 60, isOrange, 0.03);
  await assertSeen(user, [-3, 0.6, 0], 40, isGrass, 0.9);
});

/** Opens a landscape with robots, and looks at it. */
async function looksAtLandscape(t, landscape, ...robots) {
  const options = { landscape, robots, cycles: 100, width: 960, height: 540 };
  const user = await openScene(t, { x: -0.8, y: 0 }, options);
  await user.looks({ target: LANDSCAPE, azimuthDegrees: -65, elevationDegrees: 24, distance: 4.6 });
  return user;
}

picture('obstacles are on the pitch', async (t) => {
  const user = await looksAtLandscape(t, 'obstacles', { x: -3, y: 1.1 });

  await user.takesAPicture('scene-obstacles');
  await assertSeen(user, LANDSCAPE, 100, isCardboard, 0.2);
});

picture('a slope and steps are on the pitch', async (t) => {
  const user = await looksAtLandscape(t, 'slope', { x: -4.6, y: 0 });

  await user.takesAPicture('scene-slope');
  await assertSeen(user, LANDSCAPE, 100, isGrey, 0.2);
});

picture('a box is on the pitch', async (t) => {
  const user = await looksAtLandscape(t, 'box', { x: -3.6, y: 0.45 }, { number: 2, x: -3.6, y: -0.45 });

  await user.takesAPicture('scene-box');
  await assertSeen(user, LANDSCAPE, 100, isCardboard, 0.2);
});

/** Leaves only the pitch, the names of robots and what programs draw. */
function leavesThePitch() {
  for (const each of document.body.querySelectorAll('*')) {
    if (!each.querySelector('canvas, .name-tags') && !each.closest('canvas, .name-tags')) {
      each.style.visibility = 'hidden';
    }
  }
}

/** Returns the place of the ball and of the label in the middle of the way of a pass, once it is drawn. */
function passOf({ page }) {
  return page
    .waitForFunction(() => {
      const label = studio.view.drawings.texts.children.find(({ name }) => name.startsWith('pass to'));
      return label && { ball: studio.view.ball.position.toArray(), middle: label.position.toArray() };
    })
    .then((pass) => pass.jsonValue());
}

picture('a pass of the example team is drawn', async (t) => {
  const user = await newUser(t, { width: 960, height: 640, isSharp: true });
  const address = await startJava(t, await folderWith(t), 'org.robonewbie.studio.StagedPass');
  await user.visits(`${address}&quality=medium&theme=light#field`);
  await user.clicks('button', '❚❚ Pause');
  const { ball, middle } = await passOf(user);
  await user.presses('1');

  await user.looks({
    target: [...middle.slice(0, 2), 0],
    azimuthDegrees: (Math.atan2(middle[1] - ball[1], middle[0] - ball[0]) * 180) / Math.PI - 90,
    elevationDegrees: 35,
    distance: 8.5,
  });

  await user.page.evaluate(leavesThePitch);
  await user.takesAPicture('studio-pass', { x: 0, y: 170, width: 720, height: 300 });
});
