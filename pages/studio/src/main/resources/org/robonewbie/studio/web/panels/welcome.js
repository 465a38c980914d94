/** Leads a newcomer to the levels of the first minute. */
import { ask } from '../live/server.js';
import { nextLevel, SKIPPED } from '../state/program/first-minute.js';
import { recall } from './memory.js';

/** Opens the program room for a newcomer, unless the address names a room. */
export async function welcomeNewcomer() {
  if (location.hash !== '' || recall(SKIPPED, false)) {
    return;
  }
  const [course, programs] = await Promise.all(['course', 'programs'].map(async (part) => (await ask(part)).json()));
  if (nextLevel(course, programs) && location.hash === '') {
    location.replace('#program');
  }
}
