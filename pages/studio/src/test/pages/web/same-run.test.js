/** A run in the web edition, in Chromium and in Firefox, is identical bit for bit to that on the command line. */
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { launch } from '../browser.js';
import { folderWith, runCommand } from '../stage.js';
import { atEnd, slow } from '../tests.js';
import { openWebEdition } from '../user.js';

const SECONDS = 60;

async function recordingOnTheCommandLine(t, agent) {
  const folder = await folderWith(t);
  const options = ['--headless', '--fast', '--seed', '1', '--seconds', `${SECONDS}`, '--report', 'report.json'];
  await runCommand(folder, 'run', agent, ...options);
  return JSON.parse(await readFile(join(folder, 'report.json'), 'utf8')).recordingSha256;
}

async function recordingInThePage(t, agent, inFirefox) {
  const browser = await launch({ inFirefox });
  atEnd(t, () => browser.close());
  const { user } = await openWebEdition(t, { to: 'webassembly-loader.js', browser }); // a document without a world
  return user.page.evaluate(recordingOfAWorker, agent, SECONDS);
}

function recordingOfAWorker(agent, seconds) {
  return new Promise((resolve, reject) => {
    const worker = new Worker('world-worker.js', { type: 'module' });
    worker.onmessage = ({ data }) => (data.result ? resolve(data.result) : reject(new Error(data.failure)));
    worker.onerror = ({ message }) => reject(new Error(message));
    worker.postMessage({ call: { name: 'recordingSha256', args: [agent, 1, seconds] } });
  });
}

for (const agent of ['Agent_BetterSoccer', 'Agent_SimpleSoccer', 'Agent_SimpleWalkToBall']) {
  slow(`a minute of ${agent} has the same recording in both browsers and on the command line`, async (t) => {
    const expected = await recordingOnTheCommandLine(t, agent);
    assert.match(expected, /^[0-9a-f]{64}$/);

    assert.equal(await recordingInThePage(t, agent, false), expected, 'in Chromium');
    assert.equal(await recordingInThePage(t, agent, true), expected, 'in Firefox');
  });
}
