/** Collects all data about the watched robot at the displayed moment of a running simulation or a recording. */
import { CYCLE_SECONDS } from '../cycle.js';
import { readOrders, readSenses } from './senses.js';
import { recordedTraces } from './recorded-traces.js';
import { RobotMemory } from './robot-memory.js';
import { jointValues, sensedValues, trueValues } from './signals.js';
import { robotKey } from './telemetry.js';
import { Traces } from './traces.js';

/**
 * @typedef {import('../time-cursor.js').TimeCursor} TimeCursor
 * @typedef {import('../time-cursor.js').Shown} Shown
 * @typedef {import('../../live/state-frame.js').Scene} Scene
 * @typedef {import('../../live/state-frame.js').Frame} Frame
 * @typedef {import('../kinematics.js').RobotModel} RobotModel
 *
 * @typedef {object} RobotMoment state of a robot at one moment
 * @property {Scene} scene
 * @property {Frame} frame
 * @property {number} robot index of the robot
 * @property {RobotModel} model
 * @property {number} seconds
 * @property {import('./robot-memory.js').Thoughts} thoughts
 * @property {Traces} traces
 */

const MARGIN_SECONDS = 20;

/** Number of cycles shown in plots before and after the current moment. */
const TRACED_CYCLES = 3000;

export class RobotWatch {
  /** @param {(command: object) => void} send */
  constructor(send) {
    this.send = send;
    this.chosen = 0;
    this.watched = '';
    this.memory = new RobotMemory();
    this.traces = new Traces();
    this.traced = -1;
    /** @type {{cycle: number, degrees: ArrayLike<number>} | undefined} */
    this.before = undefined;
    /** @type {Record<string, number>} commanded speed of each effector; motors keep their speed until the next command */
    this.commanded = {};
    /** @type {RobotModel | undefined} */
    this.model = undefined;
    this.silent = new RobotMemory();
    /** @type {{key: string, from: number, to: number, traces: Traces} | undefined} */
    this.recorded = undefined;
  }

  /** Forgets the subscription, because a new connection has none. */
  forget() {
    this.watched = '';
  }

  /** @param {{robot: string, lines: string[], messages: Array<[number, string, string]>}} news */
  receive({ robot, lines, messages }) {
    if (robot !== this.watched) {
      return;
    }
    for (const line of lines) {
      const plotted = this.memory.receive(line);
      if (plotted) {
        this.traces.add(Math.round(plotted.seconds / CYCLE_SECONDS), [[`agent/${plotted.name}`, plotted.value]]);
      }
    }
    for (const [cycle, perceptors, effectors] of messages) {
      this.memory.exchanged({ seconds: cycle * CYCLE_SECONDS, perceptors, effectors });
      this.traces.add(cycle, sensedValues(readSenses(perceptors)));
      Object.assign(this.commanded, readOrders(effectors).speeds);
      if (this.model) {
        const speeds = this.model.hinges.map(({ effector }) => this.commanded[effector] ?? 0);
        this.traces.add(cycle, jointValues(this.model, 'commanded speed', speeds));
      }
    }
  }

  /**
   * @param {Shown} shown
   * @param {TimeCursor} cursor
   * @returns {RobotMoment | undefined} the moment; undefined if there is no robot
   */
  moment(shown, cursor) {
    const { scene, frame } = shown;
    if (!scene || !frame || scene.robots.length === 0) {
      return undefined;
    }
    this.chosen = Math.min(this.chosen, scene.robots.length - 1);
    const player = scene.robots[this.chosen];
    const model = scene.models[player.type];
    const key = robotKey(player.team, player.number);
    const seconds = frame.cycle * CYCLE_SECONDS;
    const common = { scene, frame, robot: this.chosen, model, seconds };
    if (shown.recorded) {
      return {
        ...common,
        thoughts: this.silent.at(seconds),
        traces: this.#recordedTraces(shown.recorded, key, player.id, seconds),
      };
    }
    this.#watch(key, model);
    this.#trace(cursor, key);
    return { ...common, thoughts: this.memory.at(seconds), traces: this.traces };
  }

  /** @param {string} key @param {RobotModel} model */
  #watch(key, model) {
    this.model = model;
    if (key !== this.watched) {
      this.watched = key;
      this.memory = new RobotMemory();
      this.traces = new Traces();
      this.traced = -1;
      this.before = undefined;
      this.commanded = {};
      const [team, number] = key.split('\t');
      this.send({ do: 'watch', team, number: Number(number) });
    }
  }

  /** Adds the new frames to the traces. @param {TimeCursor} cursor @param {string} key */
  #trace({ history }, key) {
    const { last } = history;
    const first = this.traced < 0 ? 0 : history.indexOf(this.traced) + 1;
    for (let i = first; i < history.kept.length; i++) {
      const { scene, frame } = history.read(i) ?? {};
      const robot = scene?.robots.findIndex(({ team, number }) => robotKey(team, number) === key) ?? -1;
      if (scene && frame && robot >= 0) {
        const model = scene.models[scene.robots[robot].type];
        this.traces.add(frame.cycle, trueValues(model, frame, robot));
        this.#traceSpeeds(model, frame, frame.robots[robot].degrees);
      }
    }
    this.traced = last;
  }

  /** @param {RobotModel} model @param {Frame} frame @param {ArrayLike<number>} degrees */
  #traceSpeeds(model, { cycle }, degrees) {
    const { before } = this;
    const passed = before ? (cycle - before.cycle) * CYCLE_SECONDS : 0;
    if (before && passed > 0 && passed < 1 && before.degrees.length === degrees.length) {
      const speeds = Array.from(degrees, (angle, i) => (angle - before.degrees[i]) / passed);
      this.traces.add(cycle, jointValues(model, 'joint speed', speeds));
    }
    this.before = { cycle, degrees };
  }

  /**
   * @param {import('../time-cursor.js').RecordedMoment} recorded
   * @param {string} robot
   * @param {number} id
   * @param {number} seconds
   */
  #recordedTraces({ name, run, scene, frame }, robot, id, seconds) {
    const key = `${name}\n${robot}\n${run.arrived}`;
    const known = this.recorded;
    if (!known || known.key !== key || seconds < known.from || seconds > known.to) {
      const moments = run.around(frame.cycle - run.firstCycle, TRACED_CYCLES);
      const traces = recordedTraces(moments, run.header, scene, id);
      const { from, to } = traces.extent;
      const last = (run.firstCycle + run.count - 1) * CYCLE_SECONDS;
      this.recorded = {
        key,
        traces,
        from: from <= run.firstCycle * CYCLE_SECONDS ? 0 : from + MARGIN_SECONDS,
        to: to >= last ? to : to - MARGIN_SECONDS,
      };
    }
    return /** @type {NonNullable<typeof this.recorded>} */ (this.recorded).traces;
  }
}
