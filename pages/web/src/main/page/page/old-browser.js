/** Detects browsers that are too old for the compiled simulator. */
import { byId } from '../panels/elements.js';

/** The smallest WebAssembly module with a garbage-collected structure. */
const PROGRAM_WITH_STRUCTURE = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1, 3, 1, 0x5f, 0];

export const isBrowserNewEnough = () =>
  typeof WebAssembly === 'object' && WebAssembly.validate(new Uint8Array(PROGRAM_WITH_STRUCTURE));

export function showBrowserAdvice() {
  byId('stage-opening').textContent =
    'This browser is too old for the simulator on this page (it lacks WebAssembly GC). Use Chromium 119, Firefox 120, Safari 18.2' +
    ' or newer, or install RoboNewbie on your computer.';
  document.body.ariaBusy = 'false';
}
