/** Guides a new user to the tutorial; see `first-minute.js`. */
import { answer } from '../live/server.js';
import { nextLevel, SKIPPED } from '../state/program/first-minute.js';
import { recall } from './memory.js';

/**
 * Opens the program room for a newcomer, unless the address specifies a room.
 *
 * @param {import('../program/program-service.js').ProgramList} programs
 */
export async function welcomeNewcomer(programs) {
  if (location.hash !== '' || recall(SKIPPED, false)) {
    return;
  }
  const course = await answer('GET course');
  if (nextLevel(course, programs) && location.hash === '') {
    location.replace('#program');
  }
}
