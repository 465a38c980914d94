/** What the tests of the Motion room have in common. */
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { openStudio } from '../user.js';

/** Degrees of a robot that stands, as they follow the time in a line of a motion. */
export const STANDING = '0 0 -90 10 0 -25 0 0 25 -50 25 0 0 0 25 -50 25 0 -90 -10 0 25';

/** Opens a motion, which may be one of `files`: texts by names without ending. */
export function openMotion(t, { motion = 'mine', files = {}, ...options } = {}) {
  const named = Object.fromEntries(Object.entries(files).map(([name, text]) => [`${name}.txt`, text]));
  return openStudio(t, { room: `motion/${encodeURIComponent(motion)}`, files: named, ...options });
}

/** Types an angle or a time into its field, without Enter. */
export async function types(user, field, text) {
  const box = await user.finds('textbox', field);
  await box.click({ count: 3 });
  await user.types(text);
}

/** Types an angle of a joint, such as `neck yaw`, and presses Enter. */
export async function turns(user, joint, degrees) {
  await types(user, `${joint} in degrees`, degrees);
  await user.presses('Enter');
}

/** Waits until the field of a joint shows an angle. */
export const readsAngle = (user, joint, degrees) => user.readsValue('textbox', `${joint} in degrees`, degrees);

/** Answers the question for a name. */
export async function answers(user, name) {
  await user.fills('textbox', 'Name', name);
  await user.presses('Enter');
}

/** Waits until the timeline shows keyframes at these times in milliseconds, and no others. */
export async function seesKeyframes(user, ...times) {
  const wanted = times.map((time, i) => `Keyframe ${i + 1} at ${(time / 1000).toFixed(2)} s`).join('\n');
  let seen = '';
  await user.until(
    async () => (seen = await user.page.$$eval('[data-keyframe]', namesOf)) === wanted,
    () => `sees keyframes\n${wanted}\non the timeline, which has\n${seen}`,
  );
}

const namesOf = (shapes) => shapes.map((shape) => shape.getAttribute('aria-label')).join('\n');

/** Returns the text of a motion in the folder. */
export const fileOf = ({ folder }, name = 'mine') => readFile(join(folder, `${name}.txt`), 'utf8');

/** Saves the open motion, which was changed, and returns the time and the degrees of each of its keyframes. */
export async function saves(studio, name = 'mine') {
  const { user } = studio;
  await user.sees(`${name} •`);
  await user.clicks('button', 'Save');
  await user.seesNo(`${name} •`);
  return keyframesIn(await fileOf(studio, name));
}

/** Returns the time and the degrees of each keyframe in the text of a motion. */
export function keyframesIn(text) {
  const numbers = text.split('\n').map((line) =>
    line
      .replace(/\/\/.*/, '')
      .trim()
      .split(/\s+/)
      .map(Number),
  );
  return numbers.filter((line) => line.length === 23 && line.every(Number.isFinite));
}

/** Waits until unsaved work on a motion is kept as a draft, and returns the path of the draft. */
export async function keepsADraft({ user, folder }, name = 'mine') {
  const draft = join(folder, '.studio', 'drafts', `${name}.txt`);
  await user.until(() => existsSync(draft));
  return draft;
}

/** Returns the point of the page at which the picture shows a limb, such as `llowerarm`. */
export async function pointOfLimb(user, limb) {
  await user.until(() => user.page.evaluate(() => !studio.motion.stale));
  return user.page.evaluate((name) => {
    const { body, stage } = studio.motion;
    const { posture, torso } = studio.motion.posedNow();
    const at = 7 * body.model.links.findIndex((link) => link.name === name);
    return [...stage.pageAt([...studio.motion.posesOf(posture, torso)].slice(at, at + 3))];
  }, limb);
}

/** Takes back one change after the other, and asserts that there are as many as expected. */
export async function takesBack(user, changes) {
  for (let i = 0; i < changes; i++) {
    await user.clicks('button', '↶ Undo');
  }
  const isDisabled = await (await user.finds('button', '↶ Undo')).evaluate((button) => button.disabled);
  assert.ok(isDisabled);
}
