/** A browser signs in with an address that works once, and stays signed in. */
import assert from 'node:assert/strict';
import { pathToFileURL } from 'node:url';
import { launch } from '../browser.js';
import { folderWith, openStage } from '../stage.js';
import { atEnd, quick, slow } from '../tests.js';
import { newUser, openStudio } from '../user.js';

const robots = [{}];
const HOW_TO_SIGN_IN = /press Enter in the terminal/i;
const REFUSED = /status of 4\d\d|WebSocket/;

/** Stops the clock, which only a signed-in page can. */
async function usesTheStudio(user, stage) {
  await user.clicks('button', '❚❚ Pause');
  await user.until(async () => (await stage.world()).isPaused);
  await stage.order({ do: 'resume' });
  await user.until(async () => !(await stage.world()).isPaused);
}

const rootOf = (address) => new URL('/', address).href;

/** What a script of the page could read of the sign-in. */
const shownAddress = (user) => user.page.evaluate(() => location.href.replace(/#.*/, '') + document.cookie);

async function newUserOf(t, inFirefox) {
  if (!inFirefox) {
    return newUser(t);
  }
  const browser = await launch({ inFirefox });
  atEnd(t, () => browser.close());
  return newUser(t, { browser, width: 800, height: 600 }); // it draws slowly
}

quick('one address serves reloads and further tabs, and does not show its code', async (t) => {
  const { user, stage } = await openStudio(t, { robots });
  await usesTheStudio(user, stage);
  const address = await user.page.evaluate(() => location.href + document.cookie);
  assert.match(address, /^http:\/\/127\.0\.0\.1:\d+\/\?quality=lowest&theme=light#field$/);

  await user.visits(`${rootOf(address)}?quality=lowest`);

  await usesTheStudio(user, stage);
});

slow('an unknown browser says how to sign in and then connects by itself', async (t) => {
  const { stage } = await openStudio(t, { robots });
  const stranger = await newUser(t);
  stranger.expectsComplaints(REFUSED);
  await stranger.page.goto(`${rootOf(await stage.address())}?quality=lowest`);
  await stranger.sees(HOW_TO_SIGN_IN);

  const tab = await stranger.page.browserContext().newPage();
  await tab.goto(await stage.address());
  await stranger.page.bringToFront();

  await stranger.seesNo(HOW_TO_SIGN_IN);
  await usesTheStudio(stranger, stage);
});

for (const [name, inFirefox] of Object.entries({ Chromium: false, Firefox: true })) {
  slow(`page files let ${name} in, and two studios do not log each other out`, async (t) => {
    const folder = await folderWith(t);
    const stages = [await openStage(t, folder, { robots }), await openStage(t, folder, { robots })];
    const user = await newUserOf(t, inFirefox);
    for (const stage of stages) {
      await user.page.goto(pathToFileURL(await stage.pageFile(folder)).href);
      await usesTheStudio(user, stage);
      assert.equal(await shownAddress(user), rootOf(await stage.address()));
    }

    for (const stage of stages) {
      await user.visits(rootOf(await stage.address()));
      await usesTheStudio(user, stage);
    }
  });

  slow(`a used address says in ${name} how to get another one`, async (t) => {
    const user = await newUserOf(t, inFirefox);
    user.expectsComplaints(REFUSED);
    const stage = await openStage(t, await folderWith(t), { robots });
    const address = await stage.address();
    await fetch(address, { redirect: 'manual' });

    await user.visits(address);

    await user.finds('heading', 'This address has already been used');
    await user.sees(HOW_TO_SIGN_IN);
  });
}
