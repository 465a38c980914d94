/**
 * Makes the one file of CodeMirror that the studio serves, and its licence: `npm install && npm run vendor`. With --check it
 * changes nothing and fails if the file is another one than these versions give.
 */
import { createHash } from 'node:crypto';
import { readFile, writeFile } from 'node:fs/promises';
import { build } from 'esbuild';

const PLACE = 'src/main/resources/org/robonewbie/studio/web/vendor/codemirror';
const FILE = `${PLACE}/codemirror.js`;
const HASH = 'src/vendor/codemirror.sha256';
const LICENSE = 'node_modules/@codemirror/view/LICENSE';

const { outputFiles } = await build({
  entryPoints: ['src/vendor/codemirror.js'],
  bundle: true,
  write: false,
  format: 'esm',
  minify: true,
  target: 'es2022',
  charset: 'utf8',
  legalComments: 'none',
});
const made = Buffer.from(outputFiles[0].contents);
const hash = createHash('sha256').update(made).digest('hex');
if (process.argv.includes('--check')) {
  const known = (await readFile(HASH, 'utf8')).trim();
  console.log(hash === known ? 'CodeMirror is as it was built.' : `CodeMirror would be ${hash}, not ${known}.`);
  process.exitCode = hash === known ? 0 : 1;
} else {
  await writeFile(FILE, made);
  await writeFile(`${PLACE}/LICENSE`, await readFile(LICENSE));
  await writeFile(HASH, `${hash}\n`);
  console.log(`${FILE}: ${made.length} bytes, ${hash}`);
}
