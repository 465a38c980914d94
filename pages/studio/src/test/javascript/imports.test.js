import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../../main/resources/org/robonewbie/studio/web/', import.meta.url));

/** The scripts that a script imports, without imports in type comments. @param {string} script @returns {string[]} */
function imports(script) {
  const found = readFileSync(script, 'utf8').matchAll(
    /^(?:import|export|\})[^;]*? from '(\.[^']+)'|\bimport '(\.[^']+)'/gmu,
  );
  return [...found].map(([, from, bare]) => join(dirname(script), from ?? bare ?? ''));
}

test('scripts have no cyclic imports', () => {
  const scripts = readdirSync(ROOT, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.js') && !name.startsWith('vendor'))
    .map((name) => join(ROOT, name));
  const remaining = new Map(
    scripts.map((script) => [script, imports(script).filter((other) => scripts.includes(other))]),
  );
  assert.ok([...remaining.values()].flat().length > scripts.length);

  let before;
  do {
    before = remaining.size;
    for (const [script, others] of remaining) {
      if (!others.some((other) => remaining.has(other))) {
        remaining.delete(script);
      }
    }
  } while (remaining.size < before);

  assert.deepEqual([...remaining.keys()], []);
});
