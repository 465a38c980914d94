/** Measures the web edition for `docs/web.md`, in a Chromium without a graphics card. */
import { execFile } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { promisify } from 'node:util';
import { fileURLToPath } from 'node:url';
import { EDITOR, openWebEdition } from '../user.js';
import { measurement, millisOf, processesOf, report, reportTimes } from './measurement.js';

const OPENINGS = 6;
const RUNS = 4;
const SLIDES = 20;
const MINUTES_ON_THE_JVM = 20;
const COMMAND = fileURLToPath(new URL('../../../../../../app/target/robonewbie.jar', import.meta.url));

const TUNABLE = `import org.robonewbie.agent.Agent;

public class MyAgent extends Agent {
    private final double gain = number("gain", 0.5, 0, 1);

    @Override
    protected void think() {
        nao.plot("gain", gain);
    }
}
`;

/** Prints the memory of the open page, whose process is the largest of its kind; on Linux only. */
async function reportMemory(t, what, user) {
  const renderers = (await processesOf(user)).filter(({ type }) => type === 'renderer');
  const texts = await Promise.all(renderers.map(({ id }) => readFile(`/proc/${id}/smaps_rollup`, 'utf8')));
  const kilobytes = Math.max(...texts.map((text) => Number(/^Pss:\s+(\d+)/m.exec(text)[1])));
  report(t, `memory of ${what}: ${((1024 * kilobytes) / 1e6).toFixed(0)} MB`);
}

/** Notes the times of the first paint, of the first picture with a robot, and of its 60th cycle. */
function notesTheRobot() {
  let robot = 0;
  const look = () => {
    const frame = window.studio?.state.frame;
    if (!robot && document.querySelector('#stage[data-drawn]') && frame?.robots.length) {
      robot = performance.now();
    }
    if (robot && frame.cycle >= 60) {
      const paint = performance.getEntriesByName('first-contentful-paint')[0]?.startTime;
      window.opened = { paint, robot, moving: performance.now() };
    } else {
      requestAnimationFrame(look);
    }
  };
  look();
}

measurement('open: until the robot is in the picture and moves', async (t) => {
  const times = [];
  for (let i = 0; i < OPENINGS; i++) {
    const { user } = await openWebEdition(t, { isSharp: true, before: notesTheRobot });
    times.push(await (await user.page.waitForFunction(() => window.opened)).jsonValue());
    await reportMemory(t, 'field and robot', user);
    await user.page.close();
  }
  reportTimes(
    t,
    'first paint',
    times.map(({ paint }) => paint),
  );
  reportTimes(
    t,
    'robot in the picture',
    times.map(({ robot }) => robot),
  );
  reportTimes(
    t,
    'cycle 60',
    times.map(({ moving }) => moving),
  );
});

/** Plays a minute in a worker of the page, and returns the milliseconds. */
const minuteInThePage = ({ page }, seed) =>
  page.evaluate(
    (args) =>
      new Promise((done, fail) => {
        window.runner ??= new Worker('world-worker.js', { type: 'module' });
        const begin = performance.now();
        window.runner.onmessage = ({ data }) =>
          data.result ? done(performance.now() - begin) : fail(new Error(JSON.stringify(data)));
        window.runner.postMessage({ call: { id: 1, name: 'recordingSha256', args } });
      }),
    ['Agent_BetterSoccer', seed, 60],
  );

measurement('run: a simulated minute without a picture, in the page and on the JVM', async (t) => {
  const { user } = await openWebEdition(t, { to: 'webassembly-loader.js' });
  const times = [];
  for (let seed = 1; seed <= RUNS; seed++) {
    times.push(await minuteInThePage(user, seed));
  }
  reportTimes(t, 'a minute in the page', times);
  const options = ['--headless', '--fast', '--seed', '1', '--seconds', String(60 * MINUTES_ON_THE_JVM)];
  const java = ['-jar', COMMAND, 'run', 'Agent_BetterSoccer', ...options];
  reportTimes(t, 'a minute on the JVM', [
    (await millisOf(() => promisify(execFile)('java', java))) / MINUTES_ON_THE_JVM,
  ]);
});

/** Moves the slider, and returns the milliseconds until the robot reports the value. */
const slides = ({ page }, value) =>
  page.evaluate(
    (wanted) =>
      new Promise((done) => {
        const room = studio.rooms.program;
        const { receive } = Object.getPrototypeOf(room);
        const begin = performance.now();
        room.receive = (news) => {
          if (news.lines.some((line) => line.startsWith('plot') && line.endsWith(`\t${wanted}`))) {
            delete room.receive;
            done(performance.now() - begin);
          }
          receive.call(room, news);
        };
        const slider = document.querySelector('#program-sliders input');
        slider.value = wanted;
        slider.dispatchEvent(new Event('input'));
      }),
    value,
  );

measurement('slider: from a slider of the Program room to the robot', async (t) => {
  const { user } = await openWebEdition(t, { to: '#program', isSharp: true });
  await user.writes(TUNABLE);
  await user.clicks('button', '▶ Run');
  await user.reads('textbox', EDITOR, '= 0.5');
  await user.finds('slider', 'gain');
  const times = [];
  for (let i = 1; i <= SLIDES; i++) {
    times.push(await slides(user, i % 2 === 0 ? '0.2' : '0.7'));
  }
  reportTimes(t, 'from slider to robot', times);
  await reportMemory(t, 'field and robot with program, editor and compiler', user);
});
