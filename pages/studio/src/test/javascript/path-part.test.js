import assert from 'node:assert/strict';
import test from 'node:test';
import { pathPart } from '../../main/resources/org/robonewbie/studio/web/state/path-part.js';

test('ordinary names are unchanged', () => {
  assert.equal(decodeURIComponent(pathPart('Kick 2 (left), v1.1 äö')), 'Kick 2 (left), v1.1 äö');
});

test('no name resolves to another address or to one that a server refuses', () => {
  for (const name of ['..', '.', 'a/b', '../../x', 'a\\b', '50%', 'a\u0000b', 'a\nb']) {
    const { pathname } = new URL(`scenes/${pathPart(name)}`, 'http://localhost/api/');

    assert.ok(pathname.startsWith('/api/scenes/') && pathname.length > 12, pathname);
    assert.doesNotMatch(pathname, /%2F|%5C|%25|%0/iu);
  }
});
