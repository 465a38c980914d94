/** Some browsers are too old for the compiled simulator. */
import { byId } from '../panels/elements.js';

/** The smallest program with a structure that the garbage collector looks after. */
const PROGRAM_WITH_STRUCTURE = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1, 3, 1, 0x5f, 0];

export const isBrowserNewEnough = () =>
  typeof WebAssembly === 'object' && WebAssembly.validate(new Uint8Array(PROGRAM_WITH_STRUCTURE));

export function sayHowToInstall() {
  byId('stage-opening').textContent =
    'This browser is too old for the simulator in this page (it lacks WebAssembly GC): take Chromium 119, Firefox 120, Safari 18.2' +
    ' or newer, or install RoboNewbie on your computer.';
}
