/** The studio shows a foreign simulation: a server with a monitor port, or a recording that was given. */
import assert from 'node:assert/strict';
import { slow } from '../tests.js';
import { openStudio } from '../user.js';

const NO_CLOCK = 'The watched server has its own clock; a monitor cannot stop it.';
const MINE = 'elsewhere/my game';

async function cannotUse(user, role, name) {
  const control = await user.finds(role, name);
  await user.until(() => control.evaluate((node, why) => node.disabled && node.title === why, NO_CLOCK));
}

slow('a server is seen through its monitor port, and its clock is left alone', async (t) => {
  const { user, stage, visit } = await openStudio(t, { isForeign: true, robots: [{}], recordings: ['game'] });
  await user.sees('Blue_Newbies');
  await user.until(() => user.page.evaluate(() => studio.view.robots.meshes.some((mesh) => mesh.visible)));

  await user.sees(NO_CLOCK);
  await cannotUse(user, 'button', '❚❚ Pause');
  await cannotUse(user, 'button', 'Step');
  await cannotUse(user, 'combobox', 'Speed');
  await user.findsNo('region', 'Puppet');
  await user.seesNo('Add a puppet');
  await user.reads('region', 'First steps', 'Drag the ball somewhere else');
  await user.findsNo('region', 'Scenes');
  await user.presses(' ');
  await user.sees('A simulation in another process cannot be paused');
  await user.clicks('button', 'Tools ▾');
  await user.clicks('button', '◀ Kick off');
  await user.sees('Kick-off · Blue_Newbies');
  assert.equal((await stage.world()).isPaused, false);

  await visit('replay/game');
  await cannotUse(user, 'button', 'Start here');

  await visit('robot');
  await user.sees(/Accelerometer\s+–\s+Gyroscope\s+–\s+Left foot\s+–\s+Right foot\s+–/); // a monitor does not know what robots sense
});

slow('a server without exercises does not offer them', async (t) => {
  const { user } = await openStudio(t, { isForeign: true, robots: [{}] });
  await user.sees('Blue_Newbies');

  await user.finds('link', 'Field');
  await user.findsNo('link', 'Exercises');
});

slow('a recording that is opened by its name is shown at once', async (t) => {
  const { user } = await openStudio(t, { room: 'replay/my%20game', recordings: [MINE], openedRecording: MINE });

  await user.sees('my game');
  await user.until(() => user.page.evaluate(() => studio.view.robots.poses.length === 1 && studio.view.drawCalls > 0));
  await user.clicks('button', '▶ Play');
  await user.until(() => user.page.evaluate(() => studio.replay.state.index > 20));
});
