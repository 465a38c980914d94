/** What the tests of the Replay room share. */
import { openStudio } from '../user.js';

/** Time shown of a whole recording. */
export const WHOLE = /\d\.\d\d of [34]\.\d\d s/;

/** Opens the Replay room with the recording `game`, and waits until it is shown unless another place of the room is asked for. */
export async function openReplay(t, options = {}) {
  const studio = await openStudio(t, { room: 'replay/game', robots: [{}], recordings: ['game'], ...options });
  if (!options.room) {
    await studio.user.sees(WHOLE);
  }
  return studio;
}

/** Returns the edges of an element on the page. */
export async function boxOf({ page }, selector) {
  const { x, y, width, height } = await (await page.$(selector)).boundingBox();
  return { left: x, right: x + width, top: y, bottom: y + height };
}
