import assert from 'node:assert/strict';
import { test } from 'node:test';
import { useStudio } from './page-modules.js';

useStudio();
const { NO_ROOM, PageStorage } = await import('../../main/page/page/page-storage.js');
const { ProgramRepository } = await import('../../main/page/page/program-repository.js');

/** A browser's storage with room for some letters. */
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

const shelfIn = (store, folder = '/') => {
  const storage = new PageStorage(() => store, folder);
  return new ProgramRepository(() => storage);
};
const paths = (entries) => entries.map(({ path }) => path);
const versionIn = (entries, wanted) => entries.find(({ path }) => path === wanted)?.version ?? '';

test('editions in two folders of a host share nothing', () => {
  const store = storeOf();
  shelfIn(store, '/').overwrite('MyAgent.java', 'root', '');
  shelfIn(store, '/2025/').overwrite('MyAgent.java', 'old', '');

  assert.equal(shelfIn(store, '/2025/').read('own', 'MyAgent.java'), 'old');
  assert.equal(shelfIn(store, '/').read('own', 'MyAgent.java'), 'root');
  assert.deepEqual(paths(shelfIn(store, '/2026/').own), []);
});

test('what the first edition kept is found again, once, in each folder, and stays where it was', () => {
  const store = storeOf();
  store.setItem('robonewbie-page-file:MyAgent.java', 'mine');
  store.setItem('robonewbie-page-draft:Other.java', 'draft');
  store.setItem('robonewbie-theme', 'dark');
  store.setItem('of another page', 'x');

  for (const folder of ['/', '/2025/']) {
    assert.equal(shelfIn(store, folder).read('own', 'MyAgent.java'), 'mine');
    assert.equal(shelfIn(store, folder).read('draft', 'Other.java'), 'draft');
  }
  shelfIn(store, '/').overwrite('MyAgent.java', 'changed', versionIn(shelfIn(store, '/').own, 'MyAgent.java'));
  shelfIn(store, '/').removeDraft('Other.java');
  assert.equal(shelfIn(store, '/').read('own', 'MyAgent.java'), 'changed');
  assert.equal(shelfIn(store, '/').read('draft', 'Other.java'), null);
  assert.equal(store.getItem('robonewbie-page-file:MyAgent.java'), 'mine');
});

test('what has no room twice is moved, and lost in no case', () => {
  const old = 'robonewbie-page-file:MyAgent.java';
  const key = `/${old}`;
  for (let room = old.length + 10; room < 2 * (key.length + 10) + 60; room += 1) {
    const store = storeOf(room, new Map([[old, 'my program']]));

    shelfIn(store);

    assert.equal(store.getItem(key) ?? store.getItem(old), 'my program', `room for ${room}`);
  }
});

test('a full storage is told in words, and what was there is there still', () => {
  const store = storeOf(200);
  const shelf = shelfIn(store);
  shelf.overwrite('MyAgent.java', 'first', '');
  const { version } = shelf.own[0];

  assert.throws(() => shelf.overwrite('MyAgent.java', 'x'.repeat(300), version), { message: NO_ROOM });
  assert.throws(() => shelf.writeDraft('MyAgent.java', 'x'.repeat(300), ''), { message: NO_ROOM });
  assert.equal(shelf.read('own', 'MyAgent.java'), 'first');
});

test('a draft that has no room beside its file makes room for it', () => {
  const text = 'x'.repeat(100);
  const shelf = shelfIn(storeOf(240));
  shelf.writeDraft('MyAgent.java', text, '');

  assert.equal(shelf.overwrite('MyAgent.java', text, '').ok, true);
  assert.equal(shelf.read('own', 'MyAgent.java'), text);
});

test('a browser that refuses its storage keeps texts as long as the page is open', () => {
  const storage = new PageStorage(() => {
    throw new DOMException('The operation is insecure.', 'SecurityError');
  }, '/');
  const shelf = new ProgramRepository(() => storage);

  shelf.overwrite('MyAgent.java', 'mine', '');

  assert.equal(storage.isLost, true);
  assert.deepEqual(paths(shelf.own), ['MyAgent.java']);
});

test('a shared program opens beside one of the same name, saved or not', () => {
  const shelf = shelfIn(storeOf());
  shelf.overwrite('MyAgent.java', 'saved', '');
  shelf.writeDraft('myagent2.java', 'unsaved', '');

  const path = shelf.takeShared('MyAgent.java', 'theirs', 'MyAgent.java');

  assert.equal(path, 'MyAgent3.java');
  assert.equal(shelf.read('own', 'MyAgent.java'), 'saved');
  assert.equal(shelf.read('draft', 'myagent2.java'), 'unsaved');
  assert.deepEqual(shelf.shared, [{ path, before: 'MyAgent.java' }]);
  shelf.overwrite(path, 'theirs', '');
  assert.deepEqual(shelf.shared, []);
});

test("one's own link opens the program that is there", () => {
  const shelf = shelfIn(storeOf());
  shelf.overwrite('MyAgent.java', 'mine', '');

  assert.equal(shelf.takeShared('MyAgent.java', 'mine', ''), 'MyAgent.java');
  assert.deepEqual(shelf.shared, []);
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
    assert.equal(shelfIn(storeOf()).takeShared(path, 'x', ''), 'Shared.java');
  });
}

test('of folders in a link only the name stays', () => {
  assert.equal(shelfIn(storeOf()).takeShared('../../src\\main/Walker.java', 'x', ''), 'Walker.java');
});

test('a window does not replace or remove the unsaved work of another one', () => {
  const shelf = shelfIn(storeOf());
  shelf.overwrite('MyAgent.java', 'saved', '');
  shelf.writeDraft('MyAgent.java', 'of one window', '');

  assert.equal(shelf.writeDraft('MyAgent.java', 'of the other', '').status, 409);
  shelf.overwrite('MyAgent.java', 'of the other', versionIn(shelf.own, 'MyAgent.java'));
  shelf.removeDraft('MyAgent.java', 'another version');

  assert.equal(shelf.read('draft', 'MyAgent.java'), 'of one window');
  assert.equal(
    shelf.writeDraft('MyAgent.java', 'of one window, longer', versionIn(shelf.drafts, 'MyAgent.java')).ok,
    true,
  );
});

test('start code never takes the place of a program, saved or not', () => {
  const shelf = shelfIn(storeOf());
  shelf.writeDraft('StopAt30.java', 'unsaved', '');
  shelf.overwrite('RaiseArms.java', 'saved', '');

  assert.equal(shelf.add('StopAt30.java', 'start code'), false);
  assert.equal(shelf.add('RaiseArms.java', 'start code'), false);
  assert.equal(shelf.add('Fresh.java', 'start code'), true);
  assert.equal(shelf.read('draft', 'StopAt30.java'), 'unsaved');
  assert.equal(shelf.read('own', 'RaiseArms.java'), 'saved');
});
