/** Measures the studio for `docs/performance.md`, in a Chromium without a graphics card on the computer that also runs the robots. */
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { request } from 'node:http';
import { join } from '../agent.js';
import { folderWith, openStage } from '../stage.js';
import { EDITOR, newUser, openStudio } from '../user.js';
import { measurement, millisOf, processesOf, report, reportTimes, seconds } from './measurement.js';

const OPENINGS = 6;
const SAVES = 15;
const PRACTICE = 3;
const SETTLING_SECONDS = 25;
const DRAWING_SECONDS = 15;
const SECONDS_IN_A_ROOM = 20;
const MAX_HEAP_BYTES = 80e6;
const MINUTES = Number(process.env.MINUTES ?? 60);
const FEED_SECONDS = 10;
const EFFECTORS = ['he1', 'he2', ...limb('lae', 4), ...limb('rae', 4), ...limb('lle', 6), ...limb('rle', 6)];
const ROOMS = ['field', 'robot', 'program', 'motion', 'replay', 'field/exercises'];

/** Look of a page as a user has it. */
const USUAL = { isSharp: true, quality: '' };

const raising = (number) => `import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

public class MyAgent extends Agent {
    public static void main(String[] args) {
        new MyAgent().run(args);
    }

    @Override
    protected void think() {
        if (nao.getTime() > 0) {
            System.out.println("program ${number}");
        }
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, 2);
    }
}
`;

function limb(name, joints) {
  return Array.from({ length: joints }, (_, i) => name + (i + 1));
}

/** Two teams that stand on their halves. */
const match = (size) =>
  Array.from({ length: size }, (_, i) => {
    const sign = i < 11 ? -1 : 1;
    const place = { x: sign * (0.8 + 1.2 * Math.floor((i % 11) / 3)), y: 1.6 * (((i % 11) % 3) - 1) };
    return { side: sign < 0 ? 'LEFT' : 'RIGHT', number: (i % 11) + 1, heading: sign < 0 ? 0 : 180, ...place };
  });

/** Notes the time of the first picture of the field. */
function notesFirstPicture() {
  const look = () => {
    if (window.studio?.view.drawCalls > 0) {
      window.firstPicture = performance.now();
    } else {
      requestAnimationFrame(look);
    }
  };
  look();
}

async function timesOfOpening({ page }) {
  await page.waitForFunction(() => window.firstPicture && performance.getEntriesByName('first-contentful-paint')[0]);
  return page.evaluate(() => ({
    paint: performance.getEntriesByName('first-contentful-paint')[0].startTime,
    picture: window.firstPicture,
  }));
}

measurement('paint: first paint of the page and first picture of the field', async (t) => {
  const times = { 'cold Java': [], 'warm Java': [], 'page seen before': [] };
  for (let i = 0; i < OPENINGS; i++) {
    const { user, visit } = await openStudio(t, { robots: [{}], ...USUAL, before: notesFirstPicture });
    times[i === 0 ? 'cold Java' : 'warm Java'].push(await timesOfOpening(user));
    await visit();
    times['page seen before'].push(await timesOfOpening(user));
    await user.page.goto('about:blank');
  }
  for (const [occasion, measured] of Object.entries(times)) {
    reportTimes(
      t,
      `${occasion}, first paint`,
      measured.map(({ paint }) => paint),
    );
    reportTimes(
      t,
      `${occasion}, first picture`,
      measured.map(({ picture }) => picture),
    );
  }
});

measurement('program: from opening the Program room to its editor and to a robot that moves', async (t) => {
  const [toEditor, toRobot] = [[], []];
  for (let i = 0; i < OPENINGS; i++) {
    const stage = await openStage(t, await folderWith(t, { 'MyAgent.java': raising(0) }), {});
    const user = await newUser(t, USUAL);
    const address = `${await stage.address()}#program`;
    const degrees = async () => (await stage.world()).robots[0]?.degrees.LEFT_SHOULDER_PITCH;
    const editor = await millisOf(async () => {
      await user.visits(address);
      await user.reads('textbox', EDITOR, /\S/);
    });
    const robot = await millisOf(async () => {
      await user.clicks('button', '▶ Run');
      await user.until(async () => (await degrees()) !== undefined);
      const before = await degrees();
      await user.until(async () => Math.abs((await degrees()) - before) > 2);
    });
    toEditor.push(editor);
    toRobot.push(editor + robot);
    await user.page.goto('about:blank');
    await stage.close();
  }
  reportTimes(t, 'from opening to the editor', toEditor);
  reportTimes(t, 'from opening to a robot that moves', toRobot);
});

measurement('save: from saving a running program to the changed one', async (t) => {
  const { user } = await openStudio(t, { room: 'program', files: { 'MyAgent.java': raising(0) }, ...USUAL });
  await user.clicks('button', '▶ Run');
  await user.reads('region', 'Output', 'program 0');
  const times = [];
  for (let i = 1; i <= PRACTICE + SAVES; i++) {
    await user.writes(raising(i));
    times.push(
      await millisOf(async () => {
        await user.presses('Control+s');
        await user.reads('region', 'Output', `program ${i}`);
      }),
    );
  }
  reportTimes(t, 'from saving to the changed program', times.slice(PRACTICE));
});

/** Counts the pictures of the field from now on. */
function countsPictures() {
  const { view } = studio;
  const draw = view.draw.bind(view);
  window.pictures = 0;
  view.draw = () => {
    window.pictures++;
    draw();
  };
}

const processorSeconds = async (user) => (await processesOf(user)).reduce((sum, { cpuTime }) => sum + cpuTime, 0);

for (const [robots, quality] of [
  [1, ''],
  [22, ''],
  [22, 'medium'],
]) {
  measurement(`pictures: pictures per second of ${robots} robots in ${quality || 'the chosen'} quality`, async (t) => {
    const look = { ...USUAL, quality, width: 1280, height: 720 };
    const { user, stage } = await openStudio(t, { robots: match(robots), ...look });
    await user.page.waitForFunction((wanted) => studio.state.scene?.robots.length === wanted, {}, robots);
    await user.presses('1');
    await seconds(SETTLING_SECONDS);
    await user.page.evaluate(countsPictures);
    const { cycle } = await stage.world();
    const work = await processorSeconds(user);
    const measured = (await millisOf(() => seconds(DRAWING_SECONDS))) / 1000;
    const pictures = await user.page.evaluate(() => window.pictures);
    const used = (await processorSeconds(user)) - work;
    const simulated = ((await stage.world()).cycle - cycle) * 0.02;

    const { name, calls } = await user.page.evaluate(() => ({
      name: studio.chooser.quality.name,
      calls: studio.view.drawCalls,
    }));
    report(
      t,
      `${(pictures / measured).toFixed(1)} pictures/s in quality ${name}, ${((1000 * used) / pictures).toFixed(0)} ms of` +
        ` processors each, ${calls} draw calls, ${(simulated / measured).toFixed(2)} times real time`,
    );
  });
}

async function heapBytes({ page }) {
  const session = await page.createCDPSession();
  await session.send('HeapProfiler.collectGarbage');
  await session.detach();
  return (await page.metrics()).JSHeapUsedSize;
}

measurement(`heap: JavaScript heap after ${MINUTES} minutes from room to room with 22 robots`, async (t) => {
  const { user } = await openStudio(t, { robots: match(22), isSharp: true });
  report(t, `at the beginning: ${((await heapBytes(user)) / 1e6).toFixed(1)} MB`);

  for (let visit = 0; visit * SECONDS_IN_A_ROOM < 60 * MINUTES; visit++) {
    await user.follows(ROOMS[visit % ROOMS.length]);
    await seconds(SECONDS_IN_A_ROOM);
  }

  const bytes = await heapBytes(user);
  report(t, `after ${MINUTES} minutes: ${(bytes / 1e6).toFixed(1)} MB`);
  assert.ok(bytes < MAX_HEAP_BYTES);
});

/** Two teams of foreign programs that move all joints in each cycle. */
function playersJoin(t, port) {
  for (const { side, number, x, y } of match(22)) {
    const turn = (cycle, joint) => (0.7 * Math.sin(0.3 * cycle + number + joint)).toFixed(4);
    const moves = (cycle) => EFFECTORS.map((effector, joint) => `(${effector} ${turn(cycle, joint)})`).join('');
    const act = (cycle) => (cycle === 3 ? `(beam ${-Math.abs(x)} ${y} 0)` : moves(cycle));
    join(t, port, { team: side, number, act });
  }
}

/** Sends a short text as a frame of a WebSocket, with a mask of zeros. */
const say = (socket, text) =>
  socket.write(Buffer.concat([Buffer.from([0x81, 0x80 | text.length, 0, 0, 0, 0]), Buffer.from(text)]));

/** Returns how many bytes the first frame of a WebSocket has, which may not be there yet. */
function frameSize(bytes) {
  const size = bytes[1];
  if (size < 126) {
    return 2 + size;
  }
  const head = size === 126 ? 4 : 10;
  return bytes.length < head
    ? Infinity
    : head + (size === 126 ? bytes.readUInt16BE(2) : Number(bytes.readBigUInt64BE(2)));
}

/** Opens the live feed as a page does, and acknowledges each picture. */
async function openFeed(address, headers) {
  const { origin } = new URL(address);
  const signIn = await fetch(address, { redirect: 'manual' });
  const upgrade = {
    Cookie: signIn.headers.get('Set-Cookie').split(';')[0],
    Origin: origin,
    Connection: 'Upgrade',
    Upgrade: 'websocket',
    'Sec-WebSocket-Version': '13',
    'Sec-WebSocket-Key': 'AAAAAAAAAAAAAAAAAAAAAA==',
    ...headers,
  };
  const [, socket, first] = await once(request(`${origin}/live`, { headers: upgrade }).end(), 'upgrade');
  let bytes = first;
  const read = () => {
    while (bytes.length >= 2 && bytes.length >= frameSize(bytes)) {
      const isPicture = (bytes[0] & 15) === 2;
      bytes = bytes.subarray(frameSize(bytes));
      if (isPicture) {
        say(socket, '{"do":"seen"}');
      }
    }
  };
  socket.on('data', (chunk) => {
    bytes = Buffer.concat([bytes, chunk]);
    read();
  });
  read();
  return socket;
}

measurement('stream: bytes per second to a page that shows 22 moving robots', async (t) => {
  const stage = await openStage(t, await folderWith(t), {});
  playersJoin(t, stage.agentPort);
  await seconds(FEED_SECONDS);
  for (const [form, headers] of [
    ['compressed', { 'Sec-WebSocket-Extensions': 'permessage-deflate' }],
    ['plain', {}],
  ]) {
    for (const [what, command] of [
      ['pictures', ''],
      ['with the messages of one robot', '{"do":"watch","team":"LEFT","number":1}'],
    ]) {
      const socket = await openFeed(await stage.address(), headers);
      if (command) {
        say(socket, command);
      }
      await seconds(FEED_SECONDS / 3);
      const before = socket.bytesRead;
      const took = await millisOf(() => seconds(FEED_SECONDS));
      report(t, `${form}, ${what}: ${((socket.bytesRead - before) / 1.024 / took).toFixed(1)} KiB/s`);
      socket.destroy();
    }
  }
});
