/** Loads this page's simulator in the background and starts the studio in the meantime. */
import './page/world-process.js';

await import('./page/begin.js');

export {};
