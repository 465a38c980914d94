/** Starts the studio over a world that runs in this page. Tests find it in the browser's console as `studio`. */
import { AgentChoice } from './page/agent-choice.js';
import { answerInsteadOfServer } from './page/page-server.js';
import { isBrowserNewEnough, sayHowToInstall } from './page/old-browser.js';
import { WorldConnection } from './page/world-connection.js';
import { Studio } from './studio.js';

/** The studio shows nothing to whom its server has not given a token; this page is everybody's. */
const TOKEN = 'page';

function start() {
  answerInsteadOfServer();
  const options = new URLSearchParams(location.search);
  options.set('token', TOKEN);
  const studio = new Studio(
    options,
    (listener) => new WorldConnection(listener, new AgentChoice(options.get('agent'))),
  );
  Object.assign(window, { studio });
  studio.start();
  if (location.protocol !== 'file:') {
    navigator.serviceWorker?.register('service-worker.js').catch(() => {});
  }
}

if (isBrowserNewEnough()) {
  start();
} else {
  sayHowToInstall();
}
