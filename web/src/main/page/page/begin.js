/** Begins the studio over the world of this page. Tests find it in the browser's console as `studio`. */
import { Studio } from '../studio.js';
import { AgentChoice } from './agent-choice.js';
import { sayHowToInstall } from './old-browser.js';
import { answerInsteadOfServer } from './page-server.js';
import { WorldConnection } from './world-connection.js';
import { world } from './world-process.js';

/** The studio shows nothing to whom its server has not given a token; this page is everybody's. */
const TOKEN = 'page';

/** @param {Worker} worker */
function begin(worker) {
  answerInsteadOfServer();
  const options = new URLSearchParams(location.search);
  options.set('token', TOKEN);
  const choice = new AgentChoice(options.get('agent'));
  const studio = new Studio(options, (listener) => new WorldConnection(worker, listener, choice));
  Object.assign(window, { studio });
  studio.start();
  navigator.serviceWorker?.register('service-worker.js').catch(() => {});
}

if (world) {
  begin(world);
} else {
  sayHowToInstall();
}
