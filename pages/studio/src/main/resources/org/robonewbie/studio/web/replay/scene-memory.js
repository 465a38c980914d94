/**
 * Scene cache of a recording: creates a new scene only when robots, teams or play mode change, because a new scene rebuilds the 3D view.
 */
import { sceneOf } from '../state/replay/replay-state.js';

/**
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../state/replay/recording-reader.js').Moment} Moment
 */

export class SceneMemory {
  #revision = 0;
  /** @type {Moment['robots'] | undefined} */
  #roster;
  /** @type {Scene | undefined} */
  #scene;

  /** @param {Record<string, import('../state/kinematics.js').RobotModel>} models */
  constructor(models) {
    this.models = models;
  }

  /** @param {Moment} moment @param {Record<string, string>} header header of the recording @returns {Scene} */
  at(moment, header) {
    const { robots: roster, game } = moment;
    const known = this.#roster === roster ? this.#scene : undefined;
    const { teams, playModes } = known ?? { teams: { left: '', right: '' }, playModes: [] };
    if (known && teams.left === game.left && teams.right === game.right && playModes[0] === game.playMode) {
      return known;
    }
    this.#revision += this.#roster === roster ? 0 : 1;
    this.#roster = roster;
    this.#scene = sceneOf(moment, header, this.models, this.#revision);
    return this.#scene;
  }
}
