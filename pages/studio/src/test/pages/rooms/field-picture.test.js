/** The picture shows the whole pitch beside the panels, and a single robot large and from its front. */
import assert from 'node:assert/strict';
import { slow } from '../tests.js';
import { openStudio } from '../user.js';

const ENDS_OF_THE_PITCH = [
  [-6, -4, 0],
  [6, -4, 0],
  [-6, 4, 0],
  [6, 4, 0],
  [6.6, 1, 0],
  [-6.6, -1, 0],
];
const STANDING_HEIGHT = 0.366;

/** Opens the Field room and waits until the robot, if there is one, has been drawn. */
async function openField(t, options = {}) {
  const studio = await openStudio(t, { width: 1440, height: 900, ...options });
  await studio.user.page.waitForFunction(() => studio.view.drawCalls > 0);
  if (options.robots) {
    await studio.user.page.waitForFunction(() => studio.view.robots.poses[0]?.[2] > 0);
  }
  return studio;
}

/** Opens the Field room and waits until the camera has found its place before the robot. */
async function openBefore(t, robot, size = {}) {
  const studio = await openField(t, { robots: [robot], width: 1366, ...size, height: 768 });
  const { page } = studio.user;
  await page.waitForFunction(
    () => studio.camera.viewOfRobot && studio.camera.isStill && studio.view.covered.bottom > 0,
  );
  await page.waitForFunction(() => studio.view.goals.goals.every(({ opacity }) => opacity === 1 || opacity < 0.1));
  return studio;
}

/** Returns the upper and the lower end of the robot as fractions of the height above the transport bar. */
async function endsOf(user, { x, y }) {
  const bar = await (await user.finds('region', 'Time')).boundingBox();
  const { z } = await user.page.evaluate(() => {
    const { links } = studio.state.scene.models.TYPE_0;
    return { z: studio.view.robots.poses[0][7 * links.findIndex(({ name }) => name === 'head') + 2] };
  });
  const stage = await (await user.page.$('#stage')).boundingBox();
  const seen = async (height) => ((await user.pointOf(x, y, height))[1] - stage.y) / (bar.y - stage.y);
  return { top: await seen(z + 0.065), bottom: await seen(0) };
}

/** Returns the direction of the camera from a robot in degrees, counter-clockwise from its heading. */
async function bearingOf(user, { x, y, heading = 0 }) {
  const camera = await user.page.evaluate(() => ({ ...studio.view.camera.position }));
  const degrees = (Math.atan2(camera.y - y, camera.x - x) * 180) / Math.PI - heading;
  return ((((degrees + 180) % 360) + 360) % 360) - 180;
}

/** Fails unless the robot is seen large and from its front right. */
async function assertSeenFromTheFront(user, robot) {
  const { top, bottom } = await endsOf(user, robot);
  const bearing = await bearingOf(user, robot);
  assert.ok(top > 0 && bottom < 1, `from ${top} to ${bottom}`);
  assert.ok(bottom - top > 0.35 && bottom - top < 0.65, `height ${bottom - top}`);
  assert.ok(bearing > -60 && bearing < -10, `camera at ${bearing} degrees`);
}

/** Returns the number of visible posts, bars and threads in front of the robot's limbs. */
function barsInFrontOf(user) {
  return user.page.evaluate(async () => {
    const { Raycaster, Vector3 } = await import('three');
    const { camera, goals, robots } = studio.view;
    const caster = new Raycaster();
    caster.params.Line.threshold = 0.01;
    const isVisible = ({ object, point }) => object.material.opacity > 0.1 && point.z > 0.01; // without flat shadows
    return Array.from({ length: robots.poses[0].length / 7 }, (_, link) => {
      const way = new Vector3(...robots.poses[0].subarray(7 * link, 7 * link + 3)).sub(camera.position);
      caster.far = way.length();
      caster.set(camera.position, way.normalize());
      return caster.intersectObject(goals.group).filter(isVisible).length;
    }).reduce((sum, count) => sum + count);
  });
}

/** Waits until the left goal is as opaque as a condition says. */
const seesLeftGoal = (user, isFaded) =>
  user.page.waitForFunction(
    (faded) => (faded ? studio.view.goals.goals[0].opacity < 0.1 : studio.view.goals.goals[0].opacity === 1),
    {},
    isFaded,
  );

async function pressesOften(user, key, count) {
  await user.presses(...Array(count).fill(key));
}

for (const [key, name] of [
  ['1', 'Free'],
  ['3', 'Top'],
]) {
  slow(`the camera ${name} shows the whole pitch with both goals beside the panels`, async (t) => {
    const { user } = await openField(t, { robots: [{}] });

    await user.presses(key);

    for (const end of ENDS_OF_THE_PITCH) {
      const point = await user.pointOf(...end);
      const isFree = await user.page.evaluate(
        (x, y) => {
          const isInside = x >= 0 && y >= 0 && x <= innerWidth && y <= innerHeight;
          return isInside && !document.elementFromPoint(x, y)?.closest('.panel, .bar');
        },
        ...point,
      );
      assert.ok(isFree, `${end} at ${point}`);
    }
  });
}

slow('a moving picture has smooth edges, and one that stands still has all pixels', async (t) => {
  const { user } = await openField(t, { robots: [{}], quality: '', isSharp: true });
  const pixels = () => user.page.$eval('#stage canvas', ({ width, clientWidth }) => width / clientWidth);
  const isMoving = () => user.until(async () => (await pixels()) < 1.5);
  await isMoving();
  const samples = await user.page.$eval('#stage canvas', (canvas) => {
    const pen = canvas.getContext('webgl2');
    return pen.getParameter(pen.SAMPLES);
  });
  assert.ok(samples >= 4, `${samples} samples for each pixel`);

  await user.clicks('button', '❚❚ Pause');
  await user.until(async () => (await pixels()) === 2);
  await user.clicks('button', '▶ Play');

  await isMoving();
});

slow('a page before its first picture is not black', async (t) => {
  const before = () => {
    window.requestAnimationFrame = () => 0;
  };
  const { user } = await openStudio(t, { before });

  await user.sees('Drawing the pitch…');
  await user.page.waitForSelector('#stage canvas', { hidden: true });
  const colour = await user.page.$eval('#stage', (stage) => getComputedStyle(stage).backgroundColor);
  assert.equal(colour, 'rgb(223, 232, 239)');
});

slow('the ground reaches the horizon', async (t) => {
  const { user } = await openField(t, { isSharp: true });
  await user.looks({ target: [30, 0, 1.4], azimuthDegrees: 180, elevationDegrees: 2, distance: 8 });
  const [, horizon] = await user.pointOf(10_000, 0, 0);

  const [[, , blueOfTheSky]] = await user.coloursAround([300, horizon - 30], 0);
  const [[, green, blue]] = await user.coloursAround([300, horizon + 30], 0);

  assert.ok(blueOfTheSky - blue > 35 && green > blue, `sky ${blueOfTheSky}, ground ${green}, ${blue}`);
});

/** Waits until the camera belongs to the user. */
async function hasFreeCamera(user) {
  const free = await user.finds('button', 'Free');
  await user.until(() => free.evaluate((button) => button.ariaPressed === 'true'));
}

slow('cameras of a robot are not chosen without a robot', async (t) => {
  const { user } = await openField(t);
  await user.clicks('button', 'Tools ▾');
  await user.presses('PageUp');
  const corner = await user.pointOf(5, 0, 0);

  await user.presses('2');

  await user.findsNo('button', 'Follow');
  await hasFreeCamera(user);
  const [x, y] = await user.pointOf(5, 0, 0);
  assert.ok(Math.hypot(x - corner[0], y - corner[1]) < 0.5);
});

slow('the ball is never smaller than four pixels', async (t) => {
  const { user } = await openField(t);

  await user.looks({ distance: 60 });

  const [x, y, z, radius] = await user.page.evaluate(() => {
    const { position, scale } = studio.view.ball;
    return [...position.toArray(), 0.042 * scale.x];
  });
  const pixels = (await user.pointOf(x + radius, y, z))[0] - (await user.pointOf(x - radius, y, z))[0];
  assert.ok(Math.abs(pixels - 4) < 0.2, `${pixels} pixels`);
});

slow('the wheel zooms to the pointer', async (t) => {
  const { user } = await openField(t, { robots: [{}] });
  await user.clicks('button', 'Tools ▾');
  await user.presses('1');
  await hasFreeCamera(user);
  const [x, y] = await user.pointOf(3, 1, 0);
  const [left] = await user.pointOf(2, 1, 0);

  await user.page.evaluate(
    (clientX, clientY) => {
      const wheel = new WheelEvent('wheel', { deltaY: -500, clientX, clientY, cancelable: true });
      studio.view.stage.dispatchEvent(wheel);
    },
    x,
    y,
  );

  await user.until(async () => x - (await user.pointOf(2, 1, 0))[0] > 1.3 * (x - left));
  const [nowX, nowY] = await user.pointOf(3, 1, 0);
  assert.ok(Math.hypot(nowX - x, nowY - y) < 3, `${nowX} ${nowY} instead of ${x} ${y}`);
});

for (const [where, robot, size] of [
  ['at its own goal', { x: -4.9, y: 0 }],
  ['at its own goal, in a narrower window,', { x: -4.9, y: 0 }, { width: 1024 }],
  ['before its own goal', { x: -4.8, y: 0.3, heading: 180 }],
  ['at the other goal', { x: 4.9, y: 0.5, heading: -20 }],
  ['beside a post', { x: -5.8, y: -1.4, heading: 60 }],
]) {
  slow(`a single robot ${where} is seen large from its front right`, async (t) => {
    const { user } = await openBefore(t, robot, size);

    await assertSeenFromTheFront(user, robot);
    assert.equal(await barsInFrontOf(user), 0);
  });
}

slow('no other ground lies below the grass', async (t) => {
  const { user } = await openBefore(t, { x: -4.9, y: 0 });

  const grounds = await user.page.evaluate(async () => {
    const { Raycaster, Vector3 } = await import('three');
    const down = new Raycaster(new Vector3(1.3, 2, 1), new Vector3(0, 0, -1));
    const hits = down.intersectObject(studio.view.pitch);
    return hits.filter(({ object }) => object.geometry.attributes.color).length;
  });

  assert.equal(grounds, 1);
});

slow('a goal fades out while the user turns the view behind it', async (t) => {
  const { user } = await openBefore(t, { x: -4.9, y: 0 });
  await seesLeftGoal(user, false);

  await pressesOften(user, 'ArrowLeft', 24);

  await seesLeftGoal(user, true);
  await user.pointOf(0, 0, 0);
  assert.equal(await barsInFrontOf(user), 0);
  assert.equal(await user.page.evaluate(() => studio.view.goals.goals[1].opacity), 1);
  await pressesOften(user, 'ArrowRight', 24);
  await seesLeftGoal(user, false);
});

slow('the overview hides no goal', async (t) => {
  const { user } = await openBefore(t, { x: -4.8, y: 0, heading: -130 });
  await seesLeftGoal(user, true);

  await user.presses('1');

  await seesLeftGoal(user, false);
});

slow('a robot is seen from its front again after it was beamed', async (t) => {
  const { user, stage } = await openBefore(t, { x: -4.9, y: 0 });
  const place = { x: 2, y: 1, z: STANDING_HEIGHT };

  await stage.order({ do: 'placeRobot', side: 'left', number: 1, ...place, headingDegrees: -90 });

  await user.page.waitForFunction(() => studio.camera.shown.target[0] > 1.9 && studio.camera.isStill);
  await assertSeenFromTheFront(user, { ...place, heading: -90 });
});
