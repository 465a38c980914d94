/** All rooms in a browser without WebGL, such as that of a remote desktop. */
import { quick, slow } from '../tests.js';
import { openStudio } from '../user.js';

const PITCH = ['application', 'The pitch in three dimensions. Arrow keys turn the view.'];
const STANDING = `${Array(22).fill('0').join(' ')}\n`;

function leaveWebGlOut() {
  const usual = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function getContext(kind, options) {
    return kind.startsWith('webgl') ? null : usual.call(this, kind, options);
  };
}

const openWithoutWebGl = (t, room, options = {}) =>
  openStudio(t, { room, robots: [{}], isSharp: true, quality: 'low', before: leaveWebGlOut, ...options });

/** Returns the number of pixels of a picture that are blue, the colour of the left team. */
function bluePixels(canvas) {
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
  copy.drawImage(canvas, 0, 0);
  const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    count += data[i + 2] > 100 && data[i + 2] > 2 * data[i] ? 1 : 0;
  }
  return count;
}

async function seesTheRobot(user, [role, name] = PITCH) {
  const picture = await user.finds(role, name);
  await user.until(async () => (await picture.$$eval('canvas', (all) => all.length)) > 0);
  await user.until(
    async () => (await picture.$eval('canvas', bluePixels)) > 50,
    () => `sees the blue robot in ${name}`,
  );
}

quick('without WebGL, the robot is drawn without real shadows', async (t) => {
  const { user } = await openWithoutWebGl(t, 'field');

  await seesTheRobot(user);

  await user.page.waitForSelector('#banner', { hidden: true });
  await user.clicks('button', 'Tools ▾');
  await user.finds('button', 'Drop ball');
  await user.findsNo('checkbox', 'Real shadows');
});

slow('without WebGL, a dragged arm turns', async (t) => {
  const { user } = await openWithoutWebGl(t, 'motion/mine', {
    files: { 'mine.txt': `200 ${STANDING}400 ${STANDING}` },
  });
  await seesTheRobot(user, ['region', 'Robot. Drag its limbs.']);
  const [x, y] = await user.page.evaluate(() => {
    const room = studio.motion;
    const { posture, torso } = room.posedNow();
    const at = 7 * room.body.model.links.findIndex(({ name }) => name === 'llowerarm');
    return room.stage.pageAt([...room.posesOf(posture, torso)].slice(at, at + 3));
  });

  await user.drags([x, y], [x + 5, y - 60]);

  await user.clicks('button', '↶ Undo');
});

slow('without WebGL, a recording is played', async (t) => {
  const { user } = await openWithoutWebGl(t, 'replay/game@play', { recordings: ['game'] });

  await user.until(() => user.page.evaluate(() => studio.replay?.picture?.frame.cycle > 0));
  await seesTheRobot(user);
});

slow('without WebGL, a program is written beside the robot', async (t) => {
  const { user } = await openWithoutWebGl(t, 'program');

  await user.finds('button', 'Save');
  await seesTheRobot(user);
});
