/**
 * CSV table of a recording: one row for each cycle with the main roster, which is the one present for the longest time. Pure.
 *
 * @typedef {import('./recording-reader.js').Moment} Moment
 * @typedef {import('../kinematics.js').RobotModel} RobotModel
 * @typedef {{type: string, team: string, number: number}} Member
 */
import { frameOf, sceneOf } from './replay-state.js';

/** @param {ReadonlyArray<{robots: Member[], cycles: number}>} rosters @returns {Member[]} the roster present for the longest time */
export function mainRoster(rosters) {
  return rosters.reduce((best, each) => (each.cycles > best.cycles ? each : best), { robots: [], cycles: 0 }).robots;
}

/** @param {readonly Member[]} robots @param {Record<string, RobotModel>} models @returns {string} header row */
export function tableHead(robots, models) {
  const head = ['cycle', 'game_time_s', 'play_mode', 'score_left', 'score_right', 'ball_x_m', 'ball_y_m', 'ball_z_m'];
  for (const { team, number, type } of robots) {
    const name = `${team}_${number}`.replaceAll(/[^\p{L}\p{N}]+/gu, '_');
    head.push(...['x_m', 'y_m', 'z_m'].map((axis) => `${name}_${axis}`));
    head.push(...models[type].hinges.map(({ joint }) => `${name}_${joint.toLowerCase()}_deg`));
  }
  return `${head.join(',')}\n`;
}

/**
 * @param {readonly Moment[]} moments
 * @param {readonly Member[]} robots robots of the columns
 * @param {Record<string, RobotModel>} models
 * @returns {string} the rows of the moments with exactly these robots
 */
export function tableRows(moments, robots, models) {
  const key = keyOf(robots);
  /** @type {Map<readonly Member[], boolean>} */
  const known = new Map();
  return moments
    .filter((moment) => {
      const fits = known.get(moment.robots) ?? keyOf(moment.robots) === key;
      known.set(moment.robots, fits);
      return fits;
    })
    .map((moment) => `${rowOf(moment, sceneOf(moment, {}, models, 0))}\n`)
    .join('');
}

/** @param {readonly Member[]} robots */
function keyOf(robots) {
  return JSON.stringify(robots.map(({ type, team, number }) => [type, team, number]));
}

/** @param {Moment} moment @param {import('../../live/state-frame.js').Scene} scene */
function rowOf(moment, scene) {
  const { ball, robots } = frameOf(moment, scene);
  const place = (/** @type {Float32Array} */ pose) => [0, 1, 2].map((i) => pose[i].toFixed(4));
  const { game } = moment;
  return [
    moment.cycle,
    moment.gameTime.toFixed(2),
    game.playMode,
    game.scoreLeft,
    game.scoreRight,
    ...place(ball),
    ...robots.flatMap(({ torso, degrees }) => [...place(torso), ...Array.from(degrees, (angle) => angle.toFixed(2))]),
  ].join(',');
}
