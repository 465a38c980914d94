/** Starts the simulator of this page, then the studio while it loads. */
import './page/world-process.js';

await import('./page/begin.js');

export {};
