/** The worker in which the world of this page runs; it begins to load as soon as this script is read. */
import { isBrowserNewEnough } from './old-browser.js';

export const world = isBrowserNewEnough() ? new Worker('world-worker.js', { type: 'module' }) : undefined;
