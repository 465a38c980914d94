/** No work is lost in the web edition: by links, other windows, a full storage, and other editions on the same host. */
import assert from 'node:assert/strict';
import { symlink } from 'node:fs/promises';
import { join } from 'node:path';
import { deflateRawSync } from 'node:zlib';
import { folderWith } from '../stage.js';
import { serve } from '../static-server.js';
import { quick, quickInBoth } from '../tests.js';
import { EDITOR, newUser, openWebEdition, WEB_EDITION } from '../user.js';

const SHARED = 'This program was shared with you.';

const saying = (words) => `public class MyAgent extends org.robonewbie.agent.Agent {
    protected void think() {
        log.info("${words}");
    }
}
`;

const linkTo = (path, program) => `#program?shared=${deflateRawSync(`${path}\n${program}`).toString('base64url')}`;

const openProgram = (t) => openWebEdition(t, { to: '#program' });

const reads = (user, text) => user.reads('textbox', EDITOR, new RegExp(`^${text}$`));

/** Returns the names of all programs, exercises and examples. */
const programs = async (user) => (await user.reads('combobox', 'Program')).split('\n').map((name) => name.trim());

/** Writes a program, and waits until it is kept as a draft. */
async function drafts(user, text) {
  await user.writes(text);
  await user.until(async () => !(await user.isAskedBeforeClosing()));
}

async function isSaved(user) {
  const save = await user.finds('button', 'Save');
  await user.until(() => save.evaluate(({ disabled }) => disabled));
}

async function saves(user, text) {
  await user.writes(text);
  await user.clicks('button', 'Save');
  await isSaved(user);
}

async function opensHistory(user) {
  await user.clicks('button', 'History');
  await user.reads('listbox', 'Saved versions', /same as now\n.*1 line differs$/);
}

function fillTheStorage({ page }) {
  return page.evaluate(() => {
    for (let i = 0, size = 1 << 22; size > 0; i++) {
      try {
        localStorage.setItem(`filler${i}`, 'x'.repeat(size));
      } catch {
        size >>= 1;
      }
    }
  });
}

function makeSpace({ page }) {
  return page.evaluate(() => {
    const fillers = Object.keys(localStorage).filter((key) => key.startsWith('filler'));
    fillers.forEach((key) => localStorage.removeItem(key));
  });
}

quickInBoth('a shared program opens beside unsaved work', async (t) => {
  const { user, visit } = await openProgram(t);
  await drafts(user, '// mine');

  await visit(linkTo('MyAgent.java', '// theirs'));

  await reads(user, '// theirs');
  await user.sees(SHARED);
  assert.ok((await programs(user)).includes('MyAgent2.java'));
  await user.clicks('button', 'Back to my program');
  await reads(user, '// mine');
  assert.ok(!(await programs(user)).includes('MyAgent2.java'));
});

quick('saved work is kept when a shared program is run, whatever its link names', async (t) => {
  const { user, visit } = await openProgram(t);
  await saves(user, saying('mine'));

  await visit(linkTo('../../MyAgent.java', saying('theirs')));
  await user.readsValue('combobox', 'Program', 'own MyAgent2.java');
  await user.clicks('button', '▶ Run');

  await user.reads('list', 'Log of the robot', 'theirs');
  await user.seesNo(SHARED);
  await isSaved(user);
  await user.fills('combobox', 'Program', 'own MyAgent.java');
  await user.reads('textbox', EDITOR, 'mine');
  await isSaved(user);
});

quick('a changed shared program is kept when one goes back', async (t) => {
  const { user, visit } = await openProgram(t);
  await drafts(user, '// mine');
  await visit(linkTo('MyAgent.java', '// theirs'));
  await reads(user, '// theirs');
  await user.writes('// theirs, and mine');

  await user.clicks('button', 'Back to my program');
  await reads(user, '// mine');

  await user.fills('combobox', 'Program', 'own MyAgent2.java');
  await reads(user, '// theirs, and mine');
});

quick('one goes back from a changed shared program to a new one if there was none', async (t) => {
  const { user } = await openWebEdition(t, { to: linkTo('MyAgent.java', '// theirs') });
  await reads(user, '// theirs');
  await user.writes('// theirs, and mine');

  await user.clicks('button', 'Back to my program');

  await user.reads('textbox', EDITOR, 'public class MyAgent2 extends Agent');
  await user.fills('combobox', 'Program', 'own MyAgent.java');
  await reads(user, '// theirs, and mine');
});

quick('a saved version is restored after a visit', async (t) => {
  const { user, visit } = await openProgram(t);
  await saves(user, '// first');
  await saves(user, '// second');
  await opensHistory(user);

  await visit();
  await opensHistory(user);
  await user.clicks('button', 'Restore');

  await reads(user, '// first');
  await isSaved(user);
});

quick('a damaged link is reported and changes nothing', async (t) => {
  const { user, visit } = await openProgram(t);
  await drafts(user, '// mine');
  const before = await programs(user);

  await visit('#program?shared=rubbish');

  await user.sees('the link is incomplete or damaged');
  await reads(user, '// mine');
  assert.deepEqual(await programs(user), before);
});

quickInBoth('a full storage is reported and the text stays until it can be saved', async (t) => {
  const { user, visit } = await openProgram(t);
  await saves(user, '// first');
  await fillTheStorage(user);

  await user.writes('// second, and longer than the first');
  await user.clicks('button', 'Save');

  await user.sees('This browser has no space left for this page');
  await reads(user, '// second, and longer than the first');
  assert.ok(await user.isAskedBeforeClosing());
  await makeSpace(user);
  await user.clicks('button', 'Save');
  await isSaved(user);
  assert.ok(!(await user.isAskedBeforeClosing()));
  await visit();
  await reads(user, '// second, and longer than the first');
});

quick('unsaved work of another window is neither replaced nor removed', async (t) => {
  const { user, visit } = await openProgram(t);
  await user.stores('program-draft', 'MyAgent.java', '// of the other window');

  await user.writes('// of this window');

  await user.sees('Another window also has unsaved changes to MyAgent.java.');
  assert.ok(await user.isAskedBeforeClosing());
  await user.clicks('button', 'Save');
  await isSaved(user);
  await visit();
  await reads(user, '// of the other window');
  await user.clicks('button', 'Use the saved version');
  await reads(user, '// of this window');
});

quick('editions on one host have separate storages and take over old data', async (t) => {
  const folder = await folderWith(t);
  const editions = ['2025', '2026'];
  for (const edition of editions) {
    await symlink(WEB_EDITION, join(folder, edition));
  }
  const { address } = await serve(t, folder);
  const user = await newUser(t);
  await user.visits(`${address}2025/docs/index.html`);
  await user.page.evaluate(async (edition) => {
    localStorage.setItem('robonewbie-page-file:Old.java', '// kept by the first edition');
    await (await caches.open('robonewbie-0123456789abcdef')).put(edition, new Response('old'));
  }, `${address}2025/`);

  for (const edition of editions) {
    await user.visits(`${address}${edition}/#program`);
    await user.page.evaluate(async () => void (await navigator.serviceWorker.ready));
    await user.stores('program', `Only${edition}.java`, '//');
  }

  await user.reads('combobox', 'Program', 'Only2026.java');
  const names = await programs(user);
  assert.ok(names.includes('Old.java'));
  assert.ok(!names.includes('Only2025.java'));
  const caches = await user.page.evaluate(() => window.caches.keys());
  assert.deepEqual(
    caches.map((name) => name.replace(/[\w-]+$/, '')),
    editions.map((edition) => `robonewbie /some/where/${edition}/ `),
  );
});
