/** All panels and controls have room on common screens. */
import assert from 'node:assert/strict';
import { slow } from '../tests.js';
import { openStudio } from '../user.js';

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
