/** Several viewers of one studio: those that hang, vanish or sleep do not disturb the others. */
import assert from 'node:assert/strict';
import { randomBytes } from 'node:crypto';
import { get } from 'node:http';
import { launch } from '../browser.js';
import { atEnd, slow } from '../tests.js';
import { newUser, openStudio } from '../user.js';

const SMALL = { width: 640, height: 360 };
const CYCLES = 300;
const FEW_CYCLES = 60;

const shownCycle = (user) => user.page.evaluate(() => studio.state.frame?.cycle ?? 0);
const seesTheWorld = (user) => user.until(async () => (await shownCycle(user)) > 0);
const pageAddress = async (stage) => `${await stage.address()}&quality=lowest`;

/** Stops all scripts of a page, and returns a function that lets them go on. */
async function hangs({ page }) {
  const session = await page.createCDPSession();
  const paused = new Promise((resolve) => session.once('Debugger.paused', resolve));
  await session.send('Debugger.enable');
  await session.send('Debugger.pause');
  await paused;
  return async () => {
    await session.send('Debugger.resume');
    await session.send('Debugger.disable');
  };
}

/** Opens the page in a separate browser, which then crashes. */
async function vanishes(t, stage) {
  const browser = await launch();
  atEnd(t, () => browser.close());
  const page = await browser.newPage();
  await page.goto(await pageAddress(stage));
  await page.waitForFunction(() => globalThis.studio?.state.frame);
  browser.process().kill('SIGKILL');
}

/** Connects as a page does and then reads nothing, as a computer with a closed lid. */
async function sleeps(t, stage) {
  const address = new URL(await stage.address());
  const { headers } = await fetch(address, { redirect: 'manual' });
  const request = get(`${address.origin}/live`, {
    headers: {
      Connection: 'Upgrade',
      Upgrade: 'websocket',
      'Sec-WebSocket-Key': randomBytes(16).toString('base64'),
      'Sec-WebSocket-Version': '13',
      Origin: address.origin,
      Cookie: (headers.get('set-cookie') ?? '').replace(/;.*/, ''),
    },
  });
  const socket = await new Promise((resolve, reject) => {
    request.on('upgrade', (response, connection) => resolve(connection));
    request.on('response', ({ statusCode }) => reject(new Error(`status ${statusCode}`)));
    request.on('error', reject);
  });
  socket.pause();
  atEnd(t, () => socket.destroy());
}

slow(
  'a page that hangs, one that crashes and one that sleeps disturb no other, and the first catches up',
  async (t) => {
    const { user, stage } = await openStudio(t, { robots: [{}], ...SMALL });
    const hanging = await newUser(t, SMALL);
    await hanging.visits(await pageAddress(stage));
    await seesTheWorld(hanging);
    await vanishes(t, stage);
    await sleeps(t, stage);
    await seesTheWorld(user);

    const goesOn = await hangs(hanging);
    const end = (await shownCycle(user)) + CYCLES;
    const behind = [];
    for (let shown = 0; shown < end;) {
      shown = await shownCycle(user);
      behind.push((await stage.world()).cycle - shown);
    }
    await goesOn();

    const usually = behind.sort((one, other) => one - other)[Math.floor(behind.length / 2)];
    assert.ok(usually < FEW_CYCLES, `usually ${usually} cycles behind`);
    await hanging.until(async () => (await shownCycle(hanging)) > end);
  },
);
