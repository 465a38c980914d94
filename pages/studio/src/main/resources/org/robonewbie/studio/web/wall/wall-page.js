/** Page that shows a running contest: all running trials side by side, and the table of results. */
import { ReportPage } from '../live/report-page.js';
import { byId, element, setText } from '../panels/elements.js';
import { themeSwitch } from '../panels/theme.js';
import { initialWall, wallSentence, withoutWallLine, withWallNews } from '../state/wall.js';
import { TrialTile } from './trial-tile.js';

const page = new ReportPage('live-wall', initialWall(), { received: withWallNews, lost: withoutWallLine }, draw);
/** @type {Map<string, TrialTile>} */
const tiles = new Map();

function draw() {
  const wall = page.known;
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
const recording = (id) => `./#replay/${encodeURIComponent(id)}`;

function drawTiles() {
  const shown = page.known.tiles.map((tile) => {
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
  const { over, planned, columns, rows } = page.known.table;
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
  const { results } = page.known;
  byId('results-title').hidden = results.length === 0;
  if (list.children.length !== results.length) {
    list.replaceChildren(
      ...[...results].reverse().map(({ id, words }) => {
        const link = element('a', { href: recording(id), target: 'robonewbie-replay' }, id);
        return element('li', {}, link, ` ${words}`);
      }),
    );
  }
}

themeSwitch(page.options.get('theme'), () => {});
page.open();

/** Exposed in the browser's console for tests and debugging. */
Object.assign(window, {
  wall: {
    get state() {
      return page.known;
    },
  },
});
