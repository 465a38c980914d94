/** Starts the studio. Tests, and people who are curious, find it in the browser's console as `studio`. */
import { Studio } from './studio.js';

const studio = new Studio(new URLSearchParams(location.search));
Object.assign(window, { studio });
studio.start();
