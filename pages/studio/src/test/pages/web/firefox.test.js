/** The web edition in Firefox: opened once, then used without its server. */
import { launch } from '../browser.js';
import { solution } from '../solutions.js';
import { folderWith } from '../stage.js';
import { atEnd, quick } from '../tests.js';
import { newUser, openWebEdition } from '../user.js';

const MISTAKE = `public class MyAgent extends org.robonewbie.agent.Agent {
  protected void think() {
    nao.sayy("x");
  }
}
`;

async function startFirefox(t, options) {
  const browser = await launch({ inFirefox: true, ...options });
  atEnd(t, () => browser.close());
  return browser;
}

/** Waits until the page can compile and run programs without a network. */
const isKept = (user) =>
  user.until(() =>
    user.page.evaluate(async () => {
      const needed = [
        'compiler/javac.wasm',
        'compiler/library.bin',
        'programs/robonewbie.wasm',
        'vendor/codemirror/codemirror.js',
      ];
      return (await Promise.all(needed.map((name) => caches.match(name)))).every(Boolean);
    }),
  );

quick('a program is written, run and judged without a network, and kept', async (t) => {
  const profile = await folderWith(t);
  const browser = await startFirefox(t, { profile });
  const { user, server, visit } = await openWebEdition(t, { to: '#program', browser, inProfile: true });
  await user.clicks('button', '▶ Run');
  await user.sees('left shoulder 31.2 degrees');
  await isKept(user);
  await server.close();

  await visit();
  await user.writes(MISTAKE);
  await user.sees('cannot find symbol');
  await user.sees('1 error, line 3');
  await visit('#program/raise-arms');
  await user.sees('left < 30 ? 60 : 0');
  await user.writes(solution('RaiseArms.java'));
  await user.clicks('button', 'Check');
  await user.sees('Passed: 10.0 of 10 points');

  await browser.close();
  const again = await newUser(t, { browser: await startFirefox(t, { profile }), inProfile: true });
  await again.visits(`${server.address}#program`);
  await again.sees(/MyAgent\.java\s+RaiseArms\.java\s+1 Raise both arms/);
  await again.sees('class RaiseArms');
});

quick('a browser without garbage collection shows what to do', async (t) => {
  const browser = await startFirefox(t, { preferences: { 'javascript.options.wasm': false } });

  const { user } = await openWebEdition(t, { browser });

  await user.sees('install RoboNewbie on your computer');
});
