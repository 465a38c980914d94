/** A run in the page and on the JVM is identical bit for bit. */
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { launch } from '../browser.js';
import { folderWith, runJava } from '../stage.js';
import { atEnd, slow } from '../tests.js';
import { openWebEdition } from '../user.js';

const SECONDS = 60;

/** Returns the hash of the recording of a run in the page's worker. */
function recordingInThePage(agent, seconds) {
  return new Promise((resolve, reject) => {
    const worker = new Worker('world-worker.js', { type: 'module' });
    worker.onmessage = ({ data }) => (data.result ? resolve(data.result) : reject(new Error(data.failure)));
    worker.onerror = ({ message }) => reject(new Error(message));
    worker.postMessage({ call: { name: 'recordingSha256', args: [agent, 1, seconds] } });
  });
}

/** Runs an agent as the command line does. */
async function recordingOnTheJvm(t, agent) {
  const report = join(await folderWith(t), 'report.json');
  const options = ['--headless', '--fast', '--seed', '1', '--seconds', `${SECONDS}`, '--report', report];
  await runJava(`org.robonewbie.examples.${agent}`, ...options);
  return JSON.parse(await readFile(report, 'utf8')).recordingSha256;
}

for (const inFirefox of [false, true]) {
  for (const agent of ['Agent_BetterSoccer', 'Agent_SimpleSoccer', 'Agent_SimpleWalkToBall']) {
    const name = inFirefox ? 'Firefox' : 'Chromium';
    slow(`a minute of ${agent} has the same recording in ${name} and on the JVM`, async (t) => {
      const browser = inFirefox ? await launch({ inFirefox }) : undefined;
      atEnd(t, () => browser?.close());
      const { user } = await openWebEdition(t, { to: 'webassembly-loader.js', browser });

      const there = await user.page.evaluate(recordingInThePage, agent, SECONDS);

      assert.equal(there, await recordingOnTheJvm(t, agent));
    });
  }
}
