/** Starts the page on which a contest is watched: all trials that run, side by side, and the table. */
import { Connection } from '../live/connection.js';
import { byId, element, setText } from '../panels/elements.js';
import { themeSwitch } from '../panels/theme.js';
import { initialWall, wallSentence, withoutWallLine, withWallNews, withWallRefusal } from '../state/wall.js';
import { TrialTile } from './trial-tile.js';

const options = new URLSearchParams(location.search);
const token = options.get('token') ?? '';
let wall = initialWall();
let asked = false;
/** @type {Map<string, TrialTile>} */
const tiles = new Map();

/** @param {import('../state/wall.js').Wall} next */
function become(next) {
  wall = next;
  if (!asked) {
    asked = true;
    requestAnimationFrame(draw);
  }
}

function draw() {
  asked = false;
  setText(byId('contest'), wall.title);
  setText(byId('rule'), wall.rule);
  const { tone, text } = wallSentence(wall);
  byId('wall-state').dataset.tone = tone;
  setText(byId('wall-state'), text);
  drawTiles();
  drawTable();
  drawResults();
}

/** @param {string} id */
const recording = (id) => `./?token=${encodeURIComponent(token)}#replay/${encodeURIComponent(id)}`;

function drawTiles() {
  const shown = wall.tiles.map((tile) => {
    const known = tiles.get(tile.trial.id);
    known?.update(tile);
    return known ?? new TrialTile(tile, recording);
  });
  const place = byId('tiles');
  if (shown.length !== place.children.length || shown.some(({ root }, i) => place.children[i] !== root)) {
    place.replaceChildren(...shown.map(({ root }) => root));
    tiles.clear();
    shown.forEach((tile) => tiles.set(tile.id, tile));
  }
  place.dataset.count = String(shown.length);
}

function drawTable() {
  const { over, planned, columns, rows } = wall.table;
  setText(byId('progress-count'), planned > 0 ? `after ${over} of ${planned} trials` : '');
  byId('share').setAttribute('value', String(planned > 0 ? over / planned : 0));
  const text = JSON.stringify([columns, rows]);
  const table = byId('table');
  if (table.dataset.text !== text) {
    table.dataset.text = text;
    const cell = (/** @type {'th' | 'td'} */ kind) => (/** @type {string} */ words) => element(kind, {}, words);
    table.querySelector('thead')?.replaceChildren(element('tr', {}, ...['Place', 'Team', ...columns].map(cell('th'))));
    table
      .querySelector('tbody')
      ?.replaceChildren(
        ...rows.map(({ rank, team, cells }) => element('tr', {}, ...[`${rank}.`, team, ...cells].map(cell('td')))),
      );
  }
}

function drawResults() {
  const list = byId('results');
  byId('results-title').hidden = wall.results.length === 0;
  if (list.children.length !== wall.results.length) {
    list.replaceChildren(
      ...[...wall.results].reverse().map(({ id, words }) => {
        const link = element('a', { href: recording(id), target: 'robonewbie-replay' }, id);
        return element('li', {}, link, ` ${words}`);
      }),
    );
  }
}

const line = new Connection(`ws://${location.host}/live-wall?token=${encodeURIComponent(token)}`, {
  opened() {},
  lost: () => become(withoutWallLine(wall)),
  refused: (reason) => become(withWallRefusal(wall, reason)),
  told: (news) => become(withWallNews(wall, news)),
  frameArrived() {},
});
themeSwitch(options.get('theme'), () => {});
line.open();
draw();
// A browser may keep a page that was left, with its line; but the program waits for those who look.
window.addEventListener('pagehide', () => line.socket?.close());

/** What tests and the curious ask for in the browser's console. */
Object.assign(window, {
  wall: {
    get state() {
      return wall;
    },
  },
});
