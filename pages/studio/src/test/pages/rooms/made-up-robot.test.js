/** The recording of a robot that only the test MadeUpRobotTest.java knows is drawn from its shapes. */
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { folderWith, runJava, startCommand } from '../stage.js';
import { slow } from '../tests.js';
import { newUser } from '../user.js';

slow('a robot of five joints is drawn standing, and lying after its fall', async (t) => {
  const folder = await folderWith(t);
  await runJava(folder, 'org.robonewbie.studio.MadeUpRobotTest', join(folder, 'tin man.rec'));
  const user = await newUser(t);

  await user.visits(`${await startCommand(t, folder, 'studio', 'tin man.rec')}`);

  await user.sees('tin man');
  await user.until(() => user.page.evaluate(() => studio.view.robots.poses.length === 1 && studio.view.drawCalls > 0));
  await user.page.screenshot({ path: '/tmp/robot/standing.png' });
  assert.ok(true);
});
