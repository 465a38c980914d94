/**
 * Runs the tests of a folder in one process, so that all share one browser and one Java process: `node src/test/pages/all.js rooms`.
 * Further words on the command line choose files. Environment variables:
 *
 * - TESTS: `quick` or `slow` ones, those for a `picture` of the documentation or for `firefox`; all by default
 * - BROWSER: `firefox` instead of Chromium
 * - PART: `1/2` and `2/2` are halves of the files, for two processes
 * - PATIENCE: the seconds for which a user waits; 60 by default
 */
import { readdirSync } from 'node:fs';

const [folder, ...words] = process.argv.slice(2);
const [part, parts] = (process.env.PART ?? '1/1').split('/').map(Number);

const names = readdirSync(new URL(`${folder}/`, import.meta.url)).filter((name) => name.endsWith('.test.js'));
const chosen = names.filter((name) => words.length === 0 || words.some((word) => name.startsWith(word)));
for (const file of chosen.sort().filter((_, i) => i % parts === part - 1)) {
  await import(`./${folder}/${file}`);
}
