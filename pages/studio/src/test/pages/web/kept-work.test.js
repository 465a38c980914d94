/** No work of the user is lost in the web edition: links, other windows, full storage, other editions on the same host. */
import assert from 'node:assert/strict';
import { symlink } from 'node:fs/promises';
import { join } from 'node:path';
import { launch } from '../browser.js';
import { folderWith } from '../stage.js';
import { serve } from '../static-server.js';
import { atEnd, quick } from '../tests.js';
import { EDITOR, newUser, openWebEdition, WEB_EDITION } from '../user.js';

async function openProgram(t, { inFirefox = false } = {}) {
  const browser = inFirefox ? await launch({ inFirefox }) : undefined;
  atEnd(t, () => browser?.close());
  const page = await openWebEdition(t, { to: '#program', browser });
  await page.user.reads('textbox', EDITOR, 'MyAgent');
  return page;
}

/** Returns all stored texts, each as `KIND:NAME=TEXT`. */
const stored = (user) =>
  user.page.evaluate(() =>
    Object.entries(localStorage)
      .filter(([key]) => key.includes('robonewbie-page-'))
      .map(([key, text]) => `${key.replace(/.*robonewbie-page-/, '')}=${text}`)
      .sort()
      .join('\n'),
  );

const stores = (user, text) =>
  user.until(
    async () => (await stored(user)).includes(text),
    () => `stores ${text}`,
  );

/** Returns the place of a link that another user makes of a program. */
const linkTo = (user, path, text) =>
  user.page.evaluate(
    async (module, ...program) => `#${await (await import(module)).sharedHash(...program)}`,
    new URL('page/share.js', user.page.url()).href,
    path,
    text,
  );

const edits = (user, text) => user.reads('textbox', EDITOR, new RegExp(`^${text}$`));

/** Returns whether the browser asks before it closes the page. */
const asksBeforeClosing = (user) =>
  user.page.evaluate(() => !dispatchEvent(new Event('beforeunload', { cancelable: true })));

async function saves(user, text) {
  await user.writes(text);
  await user.clicks('button', 'Save');
  await stores(user, `file:MyAgent.java=${text}`);
}

async function fillTheStorage(user) {
  await user.page.evaluate(() => {
    let size = 1 << 22;
    for (let i = 0; size > 0; i += 1) {
      try {
        localStorage.setItem(`filler${i}`, 'x'.repeat(size));
      } catch {
        size >>= 1;
      }
    }
  });
}

async function makeSpace(user) {
  await user.page.evaluate(() => {
    for (const key of Object.keys(localStorage).filter((each) => each.startsWith('filler'))) {
      localStorage.removeItem(key);
    }
  });
}

for (const inFirefox of [false, true]) {
  const browser = inFirefox ? 'Firefox' : 'Chromium';

  quick(`a shared program opens beside unsaved work in ${browser}`, async (t) => {
    const { user, visit } = await openProgram(t, { inFirefox });
    await user.writes('// unsaved');
    await stores(user, 'draft:MyAgent.java=// unsaved');

    await visit(await linkTo(user, 'MyAgent.java', '// theirs'));

    await edits(user, '// theirs');
    await user.sees('This program was shared with you.');
    await stores(user, 'draft:MyAgent.java=// unsaved');
    await stores(user, 'draft:MyAgent2.java=// theirs');
    await user.clicks('button', 'Back to my program');
    await edits(user, '// unsaved');
    assert.doesNotMatch(await stored(user), /theirs/);
  });

  quick(`a full storage is reported and the text is kept in ${browser}`, async (t) => {
    const { user } = await openProgram(t, { inFirefox });
    await saves(user, '// first');
    await fillTheStorage(user);

    await user.writes('// second, and longer than the first');
    await user.clicks('button', 'Save');

    await user.sees('This browser has no space left for this page');
    await edits(user, '// second, and longer than the first');
    assert.ok(await asksBeforeClosing(user));
    assert.match(await stored(user), /file:MyAgent.java=\/\/ first/);
    await makeSpace(user);
    await user.clicks('button', 'Save');
    await stores(user, 'file:MyAgent.java=// second, and longer than the first');
    assert.equal(await asksBeforeClosing(user), false);
  });
}

quick('saved work is kept when a shared program is run', async (t) => {
  const { user, visit } = await openProgram(t);
  const mine = (await user.reads('textbox', EDITOR)).replaceAll('\n\n', '\n');
  await saves(user, mine);

  await visit(await linkTo(user, '../../MyAgent.java', `${mine}// theirs`));
  await user.readsValue('combobox', 'Program', 'own MyAgent2.java');
  await user.clicks('button', '▶ Run');

  await user.sees('left shoulder 31.2 degrees');
  await user.seesNo('shared with you');
  const all = await stored(user);
  assert.ok(all.includes(`file:MyAgent.java=${mine}\nfile:MyAgent2.java=${mine}// theirs`), all);
});

quick('a changed shared program is kept when one goes back', async (t) => {
  const { user, visit } = await openProgram(t);
  await visit(await linkTo(user, 'MyAgent.java', '// theirs'));
  await user.sees('shared with you');
  await user.writes('// theirs, and mine');

  await user.clicks('button', 'Back to my program');

  await stores(user, '=// theirs, and mine');
});

quick('a saved version is restored after a visit', async (t) => {
  const { user, visit } = await openProgram(t);
  await saves(user, '// first');
  await saves(user, '// second');
  await visit();

  await user.clicks('button', 'History');
  const versions = await user.finds('listbox', 'Saved versions');
  assert.equal(await versions.evaluate(({ options }) => options.length), 2);
  await user.clicks('button', 'Restore');

  await stores(user, 'file:MyAgent.java=// first');
  await edits(user, '// first');
});

quick('a damaged link is reported and changes nothing', async (t) => {
  const { user, visit } = await openProgram(t);
  const before = await stored(user);

  await visit('#program?shared=rubbish');

  await user.sees('the link is incomplete or damaged');
  assert.equal(await stored(user), before);
});

quick('unsaved work of another window is neither replaced nor removed', async (t) => {
  const { user } = await openProgram(t);
  await user.page.evaluate(() => {
    const draft = `${new URL('.', location.href).pathname}robonewbie-page-draft:MyAgent.java`;
    localStorage.setItem(draft, '// of the other window');
  });

  await user.writes('// of this window');

  await user.sees('Another window also has unsaved changes to MyAgent.java.');
  assert.ok(await asksBeforeClosing(user));
  await user.clicks('button', 'Save');
  await stores(user, 'file:MyAgent.java=// of this window');
  await stores(user, 'draft:MyAgent.java=// of the other window');
});

quick('editions on one host have separate storages and take over old data', async (t) => {
  const folder = await folderWith(t);
  const host = await serve(t, folder);
  const user = await newUser(t);
  for (const edition of ['2025', '2026']) {
    await symlink(WEB_EDITION, join(folder, edition));
  }
  await user.visits(`${host.address}2025/icon.svg`);
  await user.page.evaluate(async (edition) => {
    localStorage.setItem('robonewbie-page-file:Old.java', '// kept by the first edition');
    await (await caches.open('robonewbie-0123456789abcdef')).put(edition, new Response('old'));
  }, `${host.address}2025/`);

  for (const edition of ['2025', '2026']) {
    await user.visits(`${host.address}${edition}/#program`);
    await user.page.evaluate(async () => void (await navigator.serviceWorker.ready));
    await user.stores(`programs/own/Only${edition}.java`, '//');
  }

  const programs = await user.reads('combobox', 'Program', 'Only2026.java');
  assert.match(programs, /^Old\.java$/m);
  assert.doesNotMatch(programs, /Only2025/);
  const keys = await user.page.evaluate(() => caches.keys());
  assert.deepEqual(
    keys.map((key) => key.replace(/[\w-]+$/, '')),
    ['robonewbie /some/where/2025/ ', 'robonewbie /some/where/2026/ '],
  );
});
