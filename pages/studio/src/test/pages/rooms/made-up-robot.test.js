/** The recording of a robot that is defined in MadeUpRobotTest.java only is drawn from its shapes. */
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { folderWith, runJava } from '../stage.js';
import { slow } from '../tests.js';
import { openStudio } from '../user.js';

/** Opens a recording in which the robot stands for two seconds, raises an arm and falls on its face. */
async function openRecording(t) {
  const folder = await folderWith(t);
  await runJava(folder, 'org.robonewbie.studio.MadeUpRobotTest', 'tin man.rec');
  const files = { 'tin man.rec': await readFile(join(folder, 'tin man.rec')) };
  return openStudio(t, { room: 'replay/tin%20man', robots: [{}], files, isSharp: true, width: 800, height: 600 });
}

/** Returns the place of the neck, the joint below the head, which is the second link. */
const placeOfNeck = (user) => user.page.evaluate(() => [...studio.view.robots.poses[0].slice(7, 10)]);

/** Returns whether a white surface is seen at a place. */
async function isWhite(user, [x, y, z]) {
  const colours = await user.coloursAround(await user.pointOf(x, y, z), 1);
  return colours.every((colour) => Math.min(...colour) > 150);
}

slow('a robot of five joints is drawn standing, and lying after its fall', async (t) => {
  const { user } = await openRecording(t);
  await user.sees('0.00 of 4.98 s');
  await user.looks({});
  const standing = (await placeOfNeck(user)).with(2, 0.69);
  assert.ok(await isWhite(user, standing));

  await user.follows('replay/tin%20man@4.9');
  await user.sees('4.90 of 4.98 s');
  await user.looks({});

  const lying = await placeOfNeck(user);
  assert.ok(lying[2] < 0.2, `the neck is ${lying[2]} m above the ground`);
  assert.ok(await isWhite(user, lying.with(0, lying[0] + 0.05)));
  assert.ok(!(await isWhite(user, standing)));
});
