/**
 * Computes the recordings of three agents in Node.js 22 or newer: node recordings.mjs [FOLDER of the page] [SECONDS]. Each line has an
 * agent, the SHA-256 of its recording with seed 1, and how many cycles a second took.
 */
import { readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const CYCLES_PER_SECOND = 50;
const AGENTS = ['Agent_SimpleSoccer', 'Agent_BetterSoccer', 'Agent_SimpleWalkToBall'];

const folder = resolve(process.argv[2] ?? 'pages/web/target/web');
const seconds = Number(process.argv[3] ?? 60);
const { load } = await import(pathToFileURL(join(folder, 'webassembly-loader.js')).href);
const { exports } = await load(new Uint8Array(await readFile(join(folder, 'field.wasm'))));

console.log(`Node.js ${process.version}, ${seconds} s, seed 1`);
for (const agent of AGENTS) {
  const begin = performance.now();
  const sha256 = exports.recordingSha256(agent, 1, seconds);
  const cyclesPerSecond = (1000 * CYCLES_PER_SECOND * seconds) / (performance.now() - begin);
  console.log(`${agent} ${sha256} ${cyclesPerSecond.toFixed(0)} cycles/s`);
}
