/** Runs all tests in one process, because starting one for each file takes several times as long. */
import { readdirSync } from 'node:fs';

const files = readdirSync(new URL('.', import.meta.url)).filter((name) => name.endsWith('.test.js'));
for (const file of files.sort()) {
  await import(`./${file}`);
}
