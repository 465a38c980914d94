/** The room in which one robot is seen from inside: joints, surroundings, thoughts and curves. */
import { byId, element, setText } from '../panels/elements.js';
import { placeOf } from '../state/robot/robot-facts.js';
import { NO_THOUGHTS, robotKey, withTelemetry } from '../state/robot/telemetry.js';
import { grown } from '../state/robot/traces.js';
import { jointName } from '../state/motion/names.js';
import { jointBars } from './joint-bars.js';
import { plots } from './plots.js';
import { surroundingsMap } from './surroundings-map.js';

/**
 * @typedef {import('../state/studio-state.js').StudioState} StudioState
 * @typedef {import('../state/robot/telemetry.js').Thoughts} Thoughts
 */

const PICTURE_MILLISECONDS = 90;
const CYCLE_SECONDS = 0.02;
const SHOWN_LINES = 200;

/** @param {{send: (command: object) => void}} surroundings */
export function openRobotRoom(surroundings) {
  return new RobotRoom(surroundings);
}

class RobotRoom {
  /** @param {{send: (command: object) => void}} surroundings */
  constructor({ send }) {
    this.send = send;
    this.chosen = 0;
    /** @type {ReadonlyMap<string, Thoughts>} */
    this.thoughts = new Map();
    /** @type {import('../state/robot/traces.js').Trace[]} */
    this.traces = [];
    /** Names of the curves, as the person has chosen them. */
    this.curves = ['torso height', 'ball distance', 'left knee pitch', 'right knee pitch'];
    this.watched = '';
    this.lastPicture = 0;
    /** @type {{cycle: number, degrees: ArrayLike<number>, speeds: number[]}} */
    this.before = { cycle: -1, degrees: [], speeds: [] };
    const place = byId('robot-room');
    const part = (/** @type {string} */ id, /** @type {string} */ label) => {
      const made = element('section', { id, 'aria-label': label });
      place.append(made);
      return made;
    };
    const joints = part('robot-joints', 'Joints');
    const middle = part('robot-thoughts', 'Surroundings and thoughts');
    const right = part('robot-curves', 'Curves');
    this.choice = element('select', { id: 'robot-choice', 'aria-label': 'Robot' });
    this.choice.addEventListener('change', () => this.choose(Number(this.choice.value)));
    this.facts = element('p', { class: 'robot-facts', role: 'status' });
    this.motion = element('p', { class: 'robot-motion' });
    const map = element('div', { class: 'map' });
    this.log = element('ol', { class: 'log', 'aria-label': 'Log of the robot' });
    middle.append(
      element('div', { class: 'robot-head' }, this.choice, this.facts),
      this.motion,
      map,
      element('p', { class: 'faint legend' }, 'Rings are true, filled is what the robot believes.'),
      element('h2', {}, 'Log'),
      this.log,
    );
    this.adding = element('select', { id: 'add-curve', 'aria-label': 'Show another curve' });
    this.adding.addEventListener('change', () => this.#toggleCurve(this.adding.value));
    const curves = element('div', { class: 'curves' });
    right.append(element('div', { class: 'robot-head' }, element('h2', {}, 'Curves of the last 20 seconds'), this.adding), curves);
    this.drawJoints = jointBars(joints);
    this.drawMap = surroundingsMap(map);
    this.drawPlots = plots(curves);
  }

  /** What keys do here. */
  get deeds() {
    return [
      { keys: ['n', 'N'], shown: 'N', text: 'next robot', act: () => this.choose((this.chosen + 1) % Math.max(1, this.choice.options.length)) },
    ];
  }

  /** @param {number} robot index of the robot */
  choose(robot) {
    this.chosen = robot;
    this.traces = [];
    this.before = { cycle: -1, degrees: [], speeds: [] };
  }

  /** A new line to the simulator knows nothing of what was watched. */
  forget() {
    this.watched = '';
  }

  /** @param {string[]} lines */
  hear(lines) {
    this.thoughts = withTelemetry(this.thoughts, lines);
  }

  /**
   * @param {StudioState} state
   * @param {number} now milliseconds
   */
  turn({ scene, frame }, now) {
    if (!scene || !frame || now - this.lastPicture < PICTURE_MILLISECONDS) {
      return;
    }
    this.lastPicture = now;
    this.#listRobots(scene);
    if (scene.robots.length === 0) {
      setText(this.facts, 'No robot is there yet. Run an agent.');
      return;
    }
    this.chosen = Math.min(this.chosen, scene.robots.length - 1);
    const player = scene.robots[this.chosen];
    const key = robotKey(player.team, player.number);
    if (key !== this.watched) {
      this.watched = key;
      this.send({ do: 'watch', team: player.team, number: player.number });
    }
    const thoughts = this.thoughts.get(key) ?? NO_THOUGHTS;
    const model = scene.models[player.type];
    const { degrees } = frame.robots[this.chosen];
    const place = placeOf(frame, this.chosen);
    this.drawJoints(model, degrees, this.#speeds(frame.cycle, degrees));
    this.drawMap(scene, frame, this.chosen, thoughts);
    setText(this.facts, `x ${place.x.toFixed(2)} m, y ${place.y.toFixed(2)} m, looks to ${place.heading.toFixed(0)}°, ${place.stands ? 'stands' : 'lies'}`);
    const { name, keyframe } = thoughts.motion;
    setText(this.motion, name ? `Motion ${name}, on the way to keyframe ${keyframe}` : 'No motion is running');
    this.#drawLog(thoughts);
    this.#drawCurves(frame.cycle * CYCLE_SECONDS, [
      { name: 'torso height', unit: 'm', value: place.height },
      { name: 'ball distance', unit: 'm', value: place.ball },
      ...model.hinges.map(({ joint }, i) => ({ name: jointName(joint), unit: '°', value: degrees[i] })),
      ...Object.entries(thoughts.values).map(([each, value]) => ({ name: each, unit: '', value })),
    ]);
  }

  /** @param {import('../live/state-frame.js').Scene} scene */
  #listRobots({ robots }) {
    const names = robots.map(({ team, number }) => `${team} ${number}`.trim() || 'new robot');
    if ([...this.choice.options].map(({ text }) => text).join('\n') !== names.join('\n')) {
      this.choice.replaceChildren(...names.map((name, i) => element('option', { value: String(i) }, name)));
    }
    this.choice.hidden = names.length === 0;
    this.choice.value = String(this.chosen);
  }

  /** @param {number} cycle @param {ArrayLike<number>} degrees */
  #speeds(cycle, degrees) {
    const { before } = this;
    const seconds = (cycle - before.cycle) * CYCLE_SECONDS;
    if (seconds !== 0) {
      const isNext = before.cycle >= 0 && seconds > 0 && seconds < 1;
      const speeds = Array.from(degrees, (angle, i) => (isNext ? (angle - before.degrees[i]) / seconds : 0));
      this.before = { cycle, degrees, speeds };
    }
    return this.before.speeds;
  }

  /** @param {Thoughts} thoughts */
  #drawLog({ log }) {
    const last = log.at(-1);
    const key = `${log.length} ${last?.seconds} ${last?.text}`;
    if (this.log.dataset.key === key) {
      return;
    }
    this.log.dataset.key = key;
    const atEnd = this.log.scrollTop + this.log.clientHeight >= this.log.scrollHeight - 8;
    this.log.replaceChildren(
      ...log.slice(-SHOWN_LINES).map(({ seconds, level, text }) => element('li', { class: level.toLowerCase() }, element('span', { class: 'faint' }, `${seconds.toFixed(2)} s`), ` ${level === 'INFO' ? '' : `${level} `}${text}`)),
    );
    if (atEnd) {
      this.log.scrollTop = this.log.scrollHeight;
    }
  }

  /** @param {number} seconds @param {Array<{name: string, unit: string, value: number}>} values */
  #drawCurves(seconds, values) {
    const names = values.map(({ name }) => name).join('\n');
    if (this.adding.dataset.names !== names + this.curves.join()) {
      this.adding.dataset.names = names + this.curves.join();
      const options = values.map(({ name }) => element('option', { value: name }, `${this.curves.includes(name) ? '✓ ' : ''}${name}`));
      this.adding.replaceChildren(element('option', { value: '' }, 'Choose curves…'), ...options);
    }
    this.traces = grown(this.traces, seconds, values);
    this.drawPlots(this.traces.filter(({ name }) => this.curves.includes(name)));
  }

  /** @param {string} name */
  #toggleCurve(name) {
    this.curves = this.curves.includes(name) ? this.curves.filter((each) => each !== name) : [...this.curves, name].filter(Boolean);
    this.adding.value = '';
  }
}
