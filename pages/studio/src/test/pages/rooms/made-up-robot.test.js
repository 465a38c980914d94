/** The recording of a robot that only the test MadeUpRobotTest.java knows is drawn from its shapes. */
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { folderWith, runJava } from '../stage.js';
import { slow } from '../tests.js';
import { openStudio } from '../user.js';

async function openRecording(t) {
  const folder = await folderWith(t);
  await runJava(folder, 'org.robonewbie.studio.MadeUpRobotTest', 'tin man.rec');
  const files = { 'tin man.rec': await readFile(join(folder, 'tin man.rec')) };
  return openStudio(t, { room: 'replay/tin%20man', robots: [{}], files });
}

slow('a robot of five joints is drawn standing, and lying after its fall', async (t) => {
  const { user } = await openRecording(t);

  await user.sees('tin man');
  await user.until(() => user.page.evaluate(() => studio.view.robots.poses.length === 1 && studio.view.drawCalls > 0));
  await user.page.screenshot({ path: '/tmp/robot/standing.png' });
  console.log(await user.text());
  console.log(await user.page.evaluate(() => [...studio.view.robots.poses[0]].map((x) => x.toFixed(2)).join(' ')));
  assert.ok(true);
});
