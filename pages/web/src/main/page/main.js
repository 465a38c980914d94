/** Starts the simulator of this page first, which loads meanwhile, and then what shows it. */
import './page/world-process.js';

await import('./page/begin.js');

export {};
