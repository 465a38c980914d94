/** The web edition is opened once and then used without a network. */
import { solution } from '../solutions.js';
import { folderWith } from '../stage.js';
import { quickInBoth } from '../tests.js';
import { EDITOR, newUser, openWebEdition } from '../user.js';

const EMPTY = `public class MyAgent extends org.robonewbie.agent.Agent {
    protected void think() {

    }
}
`;

/** Waits until the browser keeps all that compiles and runs programs. */
const keepsTheCompiler = (user) =>
  user.until(() =>
    user.page.evaluate(async () => {
      const names = [
        'compiler/javac.wasm',
        'compiler/library.bin',
        'programs/robonewbie.wasm',
        'vendor/codemirror/codemirror.js',
      ];
      return (await Promise.all(names.map((name) => caches.match(name)))).every(Boolean);
    }),
  );

quickInBoth('a program is written, run and judged without a network, and kept', async (t) => {
  const profile = await folderWith(t);
  const { user, server, visit } = await openWebEdition(t, { to: '#program', profile });
  await user.page.evaluate(async () => void (await navigator.serviceWorker.ready));
  await user.clicks('button', '▶ Run');
  await user.reads('list', 'Log of the robot', 'left shoulder 31.2 degrees');
  await keepsTheCompiler(user);
  await server.close();

  await visit();
  await user.writes(EMPTY);
  await user.presses('ArrowUp', 'ArrowUp', 'ArrowUp', 'End');
  await user.types('nao.sayy("x");');
  await user.reads('list', 'Errors found by the compiler', /Line 3.*cannot find symbol/s);
  await visit('#program/raise-arms');
  await user.reads('textbox', EDITOR, 'left < 30 ? 60 : 0');
  await user.writes(solution('RaiseArms.java'));
  await user.clicks('button', 'Check');
  await user.sees('Passed: 10.0 of 10 points');

  await user.page.browser().close();
  const again = await newUser(t, { profile });
  await again.visits(`${server.address}#program`);
  await again.readsValue('combobox', 'Program', 'own RaiseArms.java');
  await again.reads('textbox', EDITOR, 'class RaiseArms');
  await again.fills('combobox', 'Program', 'own MyAgent.java');
  await again.reads('textbox', EDITOR, 'nao.sayy("x");');
});
