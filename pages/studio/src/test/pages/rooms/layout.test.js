/** All panels and controls have room on common screens. */
import assert from 'node:assert/strict';
import { slow } from '../tests.js';
import { EDITOR, FOR_PICTURES, openStudio } from '../user.js';
import { WHOLE } from './replay-room.js';

const KEYFRAMES = `200${' 0'.repeat(22)}\n400${' 0'.repeat(22)}\n`;

/** Rooms, and what a user waits for there. */
const ROOMS = {
  field: (user) => user.sees('Blue_Newbies 1'),
  program: (user) => user.reads('textbox', EDITOR, /\S/),
  robot: (user) => user.page.waitForFunction(() => document.querySelectorAll('.joint-row').length === 22),
  'motion/mine': (user) => user.page.waitForSelector('[data-keyframe]'),
  'replay/game': (user) => user.sees(WHOLE),
};

const openWithRobot = (t, width, height) => openStudio(t, { robots: [{}], width, height });

/** Returns the panels that leave the window or overlap each other. */
function panelsThatDoNotFit() {
  const seen = (panel) => {
    const { left, right, top, bottom } = panel.getBoundingClientRect();
    const frame = panel.closest('#side')?.getBoundingClientRect();
    return { name: panel.id, left, right, top, bottom: Math.min(bottom, frame?.bottom ?? bottom) };
  };
  const all = [...document.querySelectorAll('.panel, .bar')].filter((panel) => panel.offsetParent).map(seen);
  const panels = all.filter(({ top, bottom }) => bottom > top);
  const isOutside = (one) => one.left < 0 || one.top < 0 || one.right > innerWidth || one.bottom > innerHeight;
  const overlap = (one, other) =>
    one.right > other.left && other.right > one.left && one.bottom > other.top && other.bottom > one.top;
  return panels
    .filter((one) => isOutside(one) || panels.some((other) => other !== one && overlap(one, other)))
    .map(({ name }) => name);
}

function smallestText() {
  const texts = [...document.querySelectorAll('body *')].filter((one) => one.textContent.trim());
  return Math.min(...texts.map((one) => parseFloat(getComputedStyle(one).fontSize)));
}

/** Returns the controls that the left or right edge of the window cuts. */
function controlsBeyondTheEdge() {
  return [...document.querySelectorAll('button, select, input')]
    .filter((control) => control.checkVisibility() && !control.closest('#rooms'))
    .filter((control) => control.getBoundingClientRect().left < 0 || control.getBoundingClientRect().right > innerWidth)
    .map((control) => control.textContent);
}

/** Returns the controls beyond the window that are not inside a scroll container. */
function controlsCutOff() {
  const scrolls = (each) =>
    each &&
    each !== document.body &&
    (/auto|scroll/.test(getComputedStyle(each).overflowY) || scrolls(each.parentElement));
  return [...document.querySelectorAll('button, input, select, summary, a[href]')]
    .filter((control) => control.checkVisibility({ visibilityProperty: true }) && !scrolls(control.parentElement))
    .filter((control) => {
      const { left, top, right, bottom } = control.getBoundingClientRect();
      return left < 0 || top < 0 || right > innerWidth + 1 || bottom > innerHeight + 1;
    })
    .map((control) => control.id || control.textContent);
}

for (const [width, height] of [
  [1440, 900],
  [1366, 768],
  [1024, 768],
  [820, 1180],
]) {
  slow(`no control of a room is cut off on a screen of ${width} × ${height}`, async (t) => {
    const files = { 'mine.txt': KEYFRAMES };
    const world = { robots: [{}], isPaused: true, files, recordings: ['game'] };
    for (const theme of ['light', 'dark']) {
      const { user, visit } = await openStudio(t, { ...world, width, height, theme, ...FOR_PICTURES });
      for (const [room, isThere] of Object.entries(ROOMS)) {
        await visit(room);
        await isThere(user);
        await user.takesAPicture(`${room.replace(/\/.*/, '')}-${width}-${theme}`);
        assert.deepEqual(await user.page.evaluate(controlsCutOff), [], `${room}, ${theme}`);
      }
    }
  });
}

slow('panels fit common screens and no text is small', async (t) => {
  const { user } = await openWithRobot(t);
  await user.sees('Blue_Newbies 1');

  for (const [width, height] of [
    [1366, 768],
    [1024, 768],
    [1920, 1080],
  ]) {
    await user.page.setViewport({ width, height, deviceScaleFactor: 0.25 });
    await user.until(async () => (await user.page.evaluate(panelsThatDoNotFit)).length === 0);
    assert.ok((await user.page.evaluate(smallestText)) >= 12);
  }
});

slow('a phone shows all controls of Field and Replay', async (t) => {
  const { user } = await openWithRobot(t, 390, 844);
  const fits = async () => (await user.page.evaluate(controlsBeyondTheEdge)).length === 0;

  await user.finds('button', '❚❚ Pause');
  await user.until(fits);
  await user.clicks('link', 'Replay');
  await user.finds('region', 'Recordings');
  await user.until(fits);
  await user.clicks('link', 'Motion');

  await user.page.waitForFunction(() =>
    getComputedStyle(document.querySelector('#motion-room'), '::after').content.includes('needs a wider window'),
  );
});
