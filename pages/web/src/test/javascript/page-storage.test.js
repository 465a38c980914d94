import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useStudio } from './page-modules.js';

useStudio();
const { NO_ROOM, PageStorage } = await import('../../main/page/page/page-storage.js');
const { ProgramRepository } = await import('../../main/page/page/program-repository.js');

/** A browser storage with a limited number of characters. */
function storeOf(room = Infinity, texts = new Map()) {
  return {
    texts,
    get length() {
      return texts.size;
    },
    key: (index) => [...texts.keys()][index] ?? null,
    getItem: (key) => texts.get(key) ?? null,
    removeItem: (key) => texts.delete(key),
    setItem(key, text) {
      const others = [...texts].filter(([each]) => each !== key);
      const size = others.reduce((sum, [each, value]) => sum + each.length + value.length, 0);
      if (size + key.length + text.length > room) {
        throw new DOMException('The quota has been exceeded.', 'QuotaExceededError');
      }
      texts.set(key, text);
    },
  };
}

const repositoryIn = (store, folder = '/') => {
  const storage = new PageStorage(() => store, folder);
  return new ProgramRepository(() => storage);
};
const paths = (entries) => entries.map(({ path }) => path);
const versionIn = (entries, wanted) => entries.find(({ path }) => path === wanted)?.version ?? '';

test('editions in two folders of a host have separate storage', () => {
  const store = storeOf();
  repositoryIn(store, '/').overwrite('MyAgent.java', 'root', '');
  repositoryIn(store, '/2025/').overwrite('MyAgent.java', 'old', '');

  assert.equal(repositoryIn(store, '/2025/').read('own', 'MyAgent.java'), 'old');
  assert.equal(repositoryIn(store, '/').read('own', 'MyAgent.java'), 'root');
  assert.deepEqual(paths(repositoryIn(store, '/2026/').own), []);
});

test('data of the first edition are migrated once per folder and not removed', () => {
  const store = storeOf();
  store.setItem('robonewbie-page-file:MyAgent.java', 'mine');
  store.setItem('robonewbie-page-draft:Other.java', 'draft');
  store.setItem('robonewbie-theme', 'dark');
  store.setItem('of another page', 'x');

  for (const folder of ['/', '/2025/']) {
    assert.equal(repositoryIn(store, folder).read('own', 'MyAgent.java'), 'mine');
    assert.equal(repositoryIn(store, folder).read('draft', 'Other.java'), 'draft');
  }
  repositoryIn(store, '/').overwrite('MyAgent.java', 'changed', versionIn(repositoryIn(store, '/').own, 'MyAgent.java'));
  repositoryIn(store, '/').removeDraft('Other.java');
  assert.equal(repositoryIn(store, '/').read('own', 'MyAgent.java'), 'changed');
  assert.equal(repositoryIn(store, '/').read('draft', 'Other.java'), null);
  assert.equal(store.getItem('robonewbie-page-file:MyAgent.java'), 'mine');
});

test('data without space for two copies are moved and never lost', () => {
  const old = 'robonewbie-page-file:MyAgent.java';
  const key = `/${old}`;
  for (let room = old.length + 10; room < 2 * (key.length + 10) + 60; room += 1) {
    const store = storeOf(room, new Map([[old, 'my program']]));

    repositoryIn(store);

    assert.equal(store.getItem(key) ?? store.getItem(old), 'my program', `room for ${room}`);
  }
});

test('a full storage is reported, and the previous content is kept', () => {
  const store = storeOf(200);
  const repository = repositoryIn(store);
  repository.overwrite('MyAgent.java', 'first', '');
  const { version } = repository.own[0];

  assert.throws(() => repository.overwrite('MyAgent.java', 'x'.repeat(300), version), { message: NO_ROOM });
  assert.throws(() => repository.writeDraft('MyAgent.java', 'x'.repeat(300), ''), { message: NO_ROOM });
  assert.equal(repository.read('own', 'MyAgent.java'), 'first');
});

test('a draft without space beside its file makes room for it', () => {
  const text = 'x'.repeat(100);
  const repository = repositoryIn(storeOf(240));
  repository.writeDraft('MyAgent.java', text, '');

  assert.equal(repository.overwrite('MyAgent.java', text, '').ok, true);
  assert.equal(repository.read('own', 'MyAgent.java'), text);
});

test('a browser without storage keeps texts until the page is closed', () => {
  const storage = new PageStorage(() => {
    throw new DOMException('The operation is insecure.', 'SecurityError');
  }, '/');
  const repository = new ProgramRepository(() => storage);

  repository.overwrite('MyAgent.java', 'mine', '');

  assert.equal(storage.isLost, true);
  assert.deepEqual(paths(repository.own), ['MyAgent.java']);
});

test('a shared program opens beside one of the same name, saved or not', () => {
  const repository = repositoryIn(storeOf());
  repository.overwrite('MyAgent.java', 'saved', '');
  repository.writeDraft('myagent2.java', 'unsaved', '');

  const path = repository.takeShared('MyAgent.java', 'theirs', 'MyAgent.java');

  assert.equal(path, 'MyAgent3.java');
  assert.equal(repository.read('own', 'MyAgent.java'), 'saved');
  assert.equal(repository.read('draft', 'myagent2.java'), 'unsaved');
  assert.deepEqual(repository.shared, [{ path, before: 'MyAgent.java' }]);
  repository.overwrite(path, 'theirs', '');
  assert.deepEqual(repository.shared, []);
});

test("the user’s own link opens the existing program", () => {
  const repository = repositoryIn(storeOf());
  repository.overwrite('MyAgent.java', 'mine', '');

  assert.equal(repository.takeShared('MyAgent.java', 'mine', ''), 'MyAgent.java');
  assert.deepEqual(repository.shared, []);
});

for (const path of [
  '../../<img src=x>.java',
  '/etc/passwd',
  'CON.java',
  'a\\..\\nul.java',
  '',
  'x'.repeat(200),
  '.java',
]) {
  test(`the path ${path.slice(0, 30)} of a link becomes a plain name`, () => {
    assert.equal(repositoryIn(storeOf()).takeShared(path, 'x', ''), 'Shared.java');
  });
}

test('folders in a link are removed', () => {
  assert.equal(repositoryIn(storeOf()).takeShared('../../src\\main/Walker.java', 'x', ''), 'Walker.java');
});

test('a window does not replace or remove the unsaved work of another', () => {
  const repository = repositoryIn(storeOf());
  repository.overwrite('MyAgent.java', 'saved', '');
  repository.writeDraft('MyAgent.java', 'of one window', '');

  assert.equal(repository.writeDraft('MyAgent.java', 'of the other', '').status, 409);
  repository.overwrite('MyAgent.java', 'of the other', versionIn(repository.own, 'MyAgent.java'));
  repository.removeDraft('MyAgent.java', 'another version');

  assert.equal(repository.read('draft', 'MyAgent.java'), 'of one window');
  assert.equal(
    repository.writeDraft('MyAgent.java', 'of one window, longer', versionIn(repository.drafts, 'MyAgent.java')).ok,
    true,
  );
});

test('starter code never replaces a program, saved or not', () => {
  const repository = repositoryIn(storeOf());
  repository.writeDraft('StopAt30.java', 'unsaved', '');
  repository.overwrite('RaiseArms.java', 'saved', '');

  assert.equal(repository.add('StopAt30.java', 'start code'), false);
  assert.equal(repository.add('RaiseArms.java', 'start code'), false);
  assert.equal(repository.add('Fresh.java', 'start code'), true);
  assert.equal(repository.read('draft', 'StopAt30.java'), 'unsaved');
  assert.equal(repository.read('own', 'RaiseArms.java'), 'saved');
});
