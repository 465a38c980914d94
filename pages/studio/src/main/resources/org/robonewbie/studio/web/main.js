/** Starts the studio and exposes it in the browser's console as `studio`, for tests and debugging. */
import { Studio } from './studio.js';

const studio = new Studio(new URLSearchParams(location.search));
Object.assign(window, { studio });
studio.start();
