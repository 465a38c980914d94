/** RoboNewbie as a static page, in a subfolder of a web host. */
import assert from 'node:assert/strict';
import { quick } from '../tests.js';
import { openWebEdition } from '../user.js';

const MORE = 'Adds an agent, up to four in total; the second and fourth play against the first and third';

const cycleOf = async (user) => Number((await user.reads('region', 'Time', /cycle \d/)).match(/cycle (\d+)/)[1]);

const hasCycle = (user, isWanted) => user.until(async () => isWanted(await cycleOf(user)));

const seesRobots = async (user, ...names) => {
  for (const name of names) {
    await user.sees(name);
  }
};

quick('an agent plays without any server behind the page', async (t) => {
  const { user } = await openWebEdition(t);

  await hasCycle(user, (cycle) => cycle > 100);

  await user.sees('RoboNewbie 1');
  assert.doesNotMatch(await user.text(), /Guests \d|RoboNewbie 2/);
});

quick('the clock pauses, steps and runs faster', async (t) => {
  const { user } = await openWebEdition(t);
  await user.clicks('button', '❚❚ Pause');
  await user.finds('button', '▶ Play');
  const before = await cycleOf(user);

  await user.clicks('button', 'Step');

  await hasCycle(user, (cycle) => cycle === before + 1);
  await user.fills('combobox', 'Speed', 'fastest');
  await user.clicks('button', '▶ Play');
  await hasCycle(user, (cycle) => cycle > 3000);
  await user.readsValue('combobox', 'Speed', 'fastest');
});

quick('another agent begins in a new world', async (t) => {
  const { user } = await openWebEdition(t);
  await hasCycle(user, (cycle) => cycle > 100);

  await user.fills('combobox', 'Playing agent', 'Agent_Dance');

  await hasCycle(user, (cycle) => cycle < 100);
  const choice = await user.finds('combobox', 'Playing agent');
  assert.ok((await choice.evaluate(({ options }) => options.length)) > 10);
});

quick('four robots play, and a restart brings them back', async (t) => {
  const { user } = await openWebEdition(t);
  const all = ['RoboNewbie 1', 'RoboNewbie 2', 'Guests 1', 'Guests 2'];
  for (const agent of ['Agent_SimpleSoccer', 'Agent_BetterSoccer', 'Agent_SimpleSoccer']) {
    await user.reads('combobox', MORE, agent);
    await user.fills('combobox', MORE, agent);
  }
  await seesRobots(user, ...all);
  assert.ok(await (await user.finds('combobox', MORE)).evaluate(({ disabled }) => disabled));
  await hasCycle(user, (cycle) => cycle > 500);

  await user.clicks('button', 'Restart');

  await hasCycle(user, (cycle) => cycle > 0 && cycle < 400);
  await seesRobots(user, ...all);
});

quick('the address names all agents that play', async (t) => {
  const { user } = await openWebEdition(t, { to: '?agent=&agent=Agent_Dance&agent=Agent_SimpleSoccer' });

  await hasCycle(user, (cycle) => cycle > 100);

  await seesRobots(user, 'RoboNewbie 1', 'Guests 1');
  await user.readsValue('combobox', 'Playing agent', 'Agent_Dance');
});

quick('the Robot room shows what the robot senses and thinks', async (t) => {
  const { user } = await openWebEdition(t);

  await user.clicks('link', 'Robot');

  await user.sees('Shoulder pitch');
  await user.until(() => user.page.evaluate(() => studio.robot?.watch.memory.exchanges.length > 10));
});

quick('the page opens without a network once it was there', async (t) => {
  const { server, user, visit } = await openWebEdition(t);
  await user.page.evaluate(async () => void (await navigator.serviceWorker.ready));
  await server.close();

  await visit();

  await hasCycle(user, (cycle) => cycle > 0);
});

for (const [lack, before] of Object.entries({
  WebAssembly: () => delete globalThis.WebAssembly,
  'garbage collection in WebAssembly': () => (WebAssembly.validate = () => false),
})) {
  quick(`a browser without ${lack} shows what to do`, async (t) => {
    const { user } = await openWebEdition(t, { before });

    await user.sees('install RoboNewbie on your computer');
    assert.ok(await user.page.evaluate(() => window.studio === undefined));
  });
}
