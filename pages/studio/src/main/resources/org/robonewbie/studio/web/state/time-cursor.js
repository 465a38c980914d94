/**
 * Time cursor, shared by all rooms: the present, an earlier moment of the running simulation, or a moment of a recording. The simulation
 * continues in the meantime.
 */
import { LiveHistory } from './live-history.js';

/**
 * @typedef {import('./studio-state.js').StudioState} StudioState
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../live/state-frame.js').Frame} Frame
 * @typedef {import('./replay/recorded-run.js').RecordedRun} RecordedRun
 *
 * @typedef {object} RecordedMoment
 * @property {string} name name of the recording
 * @property {Scene} scene
 * @property {Frame} frame
 * @property {RecordedRun} run the whole recording
 * @property {import('./robot/drawing-memory.js').DrawingMemory} drawings drawings of the robots
 * @property {boolean} running whether it is the recording of the running simulation
 *
 * @typedef {object} Shown
 * @property {'live' | 'past' | 'recorded'} tense
 * @property {Scene | undefined} scene
 * @property {Frame | undefined} frame
 * @property {RecordedMoment} [recorded]
 */

export class TimeCursor {
  constructor() {
    this.history = new LiveHistory();
    /** The displayed cycle of the running simulation; undefined for the present. @type {number | undefined} */
    this.cycle = undefined;
    /** @type {RecordedMoment | undefined} */
    this.recorded = undefined;
  }

  /** Resets the cursor for another simulation. */
  restart() {
    this.history.clear();
    this.cycle = undefined;
  }

  /** Returns to the present. */
  goLive() {
    this.cycle = undefined;
    this.recorded = undefined;
  }

  /** @param {number} cycle cycle of the running simulation */
  goTo(cycle) {
    this.recorded = undefined;
    const { first, last } = this.history;
    this.cycle = cycle >= last ? undefined : Math.max(first, Math.round(cycle));
  }

  /** @param {number} cycles */
  step(cycles) {
    this.goTo((this.cycle ?? this.history.last) + cycles);
  }

  /** @param {RecordedMoment} moment */
  goToRecorded(moment) {
    this.cycle = undefined;
    this.recorded = moment;
  }

  /** @param {StudioState} state @returns {Shown} */
  shown({ scene, frame }) {
    if (this.recorded) {
      return { tense: 'recorded', scene: this.recorded.scene, frame: this.recorded.frame, recorded: this.recorded };
    }
    const past = this.cycle === undefined ? undefined : this.history.at(this.cycle);
    return past ? { tense: 'past', ...past } : { tense: 'live', scene, frame };
  }
}
