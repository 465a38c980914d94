/** State of a running contest: its tiles, its table, and the results of its trials. */
import { playModeText } from './play-mode.js';
import { phaseSentence, phaseWithoutLine } from './reports.js';
import { clock } from './studio-state.js';

/**
 * @typedef {{id: string, teams: string[], studio: string, length: number, width: number}} WallTrial
 * @typedef {{side: string, number: number, place: [number, number], heading: number, fallen: boolean}} WallRobot
 *
 * @typedef {object} Moment
 * @property {string} id
 * @property {number} seconds
 * @property {string} playMode
 * @property {string} left
 * @property {string} right
 * @property {[number, number]} score
 * @property {[number, number]} ball
 * @property {WallRobot[]} robots
 *
 * @typedef {{rank: number, team: string, cells: string[]}} Place
 * @typedef {{over: number, planned: number, columns: string[], rows: Place[]}} WallTable
 * @typedef {{id: string, words: string}} Result
 * @typedef {{trial: WallTrial, running: boolean, moment: Moment | undefined}} Tile
 *
 * @typedef {object} Wall
 * @property {import('./reports.js').Phase} phase
 * @property {string} refusal why the connection was rejected
 * @property {string} title
 * @property {string} rule
 * @property {string} outcome
 * @property {WallTable} table
 * @property {readonly Result[]} results
 * @property {readonly Tile[]} tiles
 */

/** @returns {Wall} */
export function initialWall() {
  return {
    phase: 'waiting',
    refusal: '',
    title: '',
    rule: '',
    outcome: '',
    table: { over: 0, planned: 0, columns: [], rows: [] },
    results: [],
    tiles: [],
  };
}

/**
 * @param {Wall} wall
 * @param {any} news a message from the live feed
 * @returns {Wall}
 */
export function withWallNews(wall, news) {
  if (news.kind === 'moments') {
    /** @type {Map<string, Moment>} */
    const moments = new Map(news.moments.map((/** @type {Moment} */ moment) => [moment.id, moment]));
    const tiles = wall.tiles.map((tile) => ({ ...tile, moment: moments.get(tile.trial.id) ?? tile.moment }));
    return { ...wall, tiles };
  }
  const { title, rule, outcome = '', table = wall.table, results, trials } = news;
  const phase = outcome ? 'ended' : 'running';
  return { ...wall, phase, title, rule, outcome, table, results, tiles: withTrials(wall.tiles, trials) };
}

/**
 * Assigns trials to tiles. A running trial keeps its tile; a finished one keeps its last picture until another trial needs the tile, so
 * that the tiles do not jump.
 *
 * @param {readonly Tile[]} tiles
 * @param {readonly WallTrial[]} trials running trials
 * @returns {readonly Tile[]}
 */
function withTrials(tiles, trials) {
  const running = new Set(trials.map(({ id }) => id));
  const next = tiles.map((tile) => ({ ...tile, running: running.has(tile.trial.id) }));
  for (const trial of trials) {
    if (!next.some((tile) => tile.trial.id === trial.id)) {
      const free = next.findIndex((tile) => !tile.running);
      next.splice(free < 0 ? next.length : free, free < 0 ? 0 : 1, { trial, running: true, moment: undefined });
    }
  }
  return next;
}

/** Keeps the state after the connection was lost, with all trials stopped. @param {Wall} wall @returns {Wall} */
export function withoutWallLine(wall) {
  return {
    ...wall,
    phase: phaseWithoutLine(wall.phase),
    tiles: wall.tiles.map((tile) => ({ ...tile, running: false })),
  };
}

/** @param {Wall} wall @returns {{tone: string, text: string}} */
export function wallSentence(wall) {
  return phaseSentence(wall, {
    waiting: 'Waiting for the competition …',
    running: wall.tiles.some(({ running }) => running) ? '' : 'The next trials are starting …',
    lost: 'Run the command again to continue the competition.',
    ended: `The competition is over. ${wall.outcome}`,
  });
}

/**
 * Returns the caption of a tile.
 *
 * @param {Tile} tile
 * @returns {{teams: string, time: string, mode: string}}
 */
export function tileWords({ trial, moment, running }) {
  const teams = trial.teams.join(' – ');
  if (!moment) {
    return { teams, time: '', mode: running ? 'The robots are joining …' : '' };
  }
  const { left, right, score } = moment;
  return {
    teams: trial.teams.length > 1 && left && right ? `${left} ${score[0]} : ${score[1]} ${right}` : teams,
    time: clock(moment.seconds),
    mode: running ? playModeText(moment.playMode, { left, right }) : 'Over',
  };
}
