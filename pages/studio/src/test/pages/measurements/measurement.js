/** What the measurements of the documentation share. */
import { loadavg } from 'node:os';
import { test } from 'node:test';

const LIMIT_MILLIS = 2 * 3_600_000;

/** Defines a measurement, which judges the computer and is therefore no test of a build. */
export const measurement = (title, body) => test(title, { timeout: LIMIT_MILLIS }, body);

/** Prints a line with the load of the computer. */
export const report = (t, line) => t.diagnostic(`${line}, load ${loadavg()[0].toFixed(1)}`);

/** Prints the median and the range of some times in milliseconds. */
export function reportTimes(t, what, times) {
  const sorted = [...times].sort((a, b) => a - b);
  const [median, least, most] = [sorted[Math.floor(sorted.length / 2)], sorted[0], sorted.at(-1)].map(Math.round);
  report(t, `${what}: median ${median} ms (${least} to ${most}, ${sorted.length} times)`);
}

/** Returns how many milliseconds an action takes. */
export async function millisOf(action) {
  const begin = performance.now();
  await action();
  return performance.now() - begin;
}

export const seconds = (count) => new Promise((done) => setTimeout(done, 1000 * count));

/** Returns `{ type, id, cpuTime }` of each process of the browser, the time in seconds. */
export async function processesOf({ page }) {
  const session = await page.browser().target().createCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  return processInfo;
}
