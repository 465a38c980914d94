/**
 * Runs the tests of a folder in one process, so that all share one browser and one Java process: `node src/test/pages/all.js rooms`.
 * The environment variable TESTS chooses `quick` or `slow` ones or those for a `picture` of the documentation, PATIENCE the seconds for which a user waits (60); further words on the
 * command line choose files.
 */
import { readdirSync } from 'node:fs';

const [folder, ...words] = process.argv.slice(2);
const files = readdirSync(new URL(`${folder}/`, import.meta.url)).filter((name) => name.endsWith('.test.js'));
for (const file of files.sort().filter((name) => words.length === 0 || words.some((word) => name.startsWith(word)))) {
  await import(`./${folder}/${file}`);
}
