/** The robot room: joints, senses, surroundings, beliefs, messages and plots of one robot. */
import { button, choice, element, setEntries, setText } from '../panels/elements.js';
import { sidePanel } from '../panels/side-panel.js';
import { fixed } from '../state/numbers.js';
import { placeOf } from '../state/robot/robot-facts.js';
import { RobotWatch } from '../state/robot/robot-watch.js';
import { readOrders, readSenses } from '../state/robot/senses.js';
import { cameraPicture } from './camera-picture.js';
import { jointBars } from './joint-bars.js';
import { logList } from './log-list.js';
import { messageView } from './message-view.js';
import { PlotController } from './plot-controller.js';
import { sensesPanel } from './senses-panel.js';
import { surroundingsMap } from './surroundings-map.js';

/**
 * @typedef {import('../state/time-cursor.js').TimeCursor} TimeCursor
 * @typedef {import('../state/time-cursor.js').Shown} Shown
 * @typedef {import('../state/robot/robot-watch.js').RobotMoment} RobotMoment
 * @typedef {{send: (command: object) => void, goTo: (seconds: number) => void}} Surroundings
 */

const PICTURE_MILLISECONDS = 90;
const NO_SENSES = readSenses('');

export class RobotRoom {
  /** @param {Surroundings} surroundings */
  constructor(surroundings) {
    const { send, goTo } = surroundings;
    this.watch = new RobotWatch(send);
    this.lastPicture = 0;
    const joints = sidePanel('robot', 'joints');
    const middle = sidePanel('robot', 'surroundings');
    const words = sidePanel('robot', 'words');
    const right = sidePanel('robot', 'curves');
    this.choice = choice({ id: 'robot-choice', 'aria-label': 'Robot' }, [], (robot) => this.choose(Number(robot)));
    this.facts = element('p', { class: 'robot-facts', role: 'status' });
    this.motion = element('p', { class: 'robot-motion' });
    const camera = element('figure', {}, element('figcaption', { class: 'faint' }, 'What the camera sees'));
    const map = element(
      'figure',
      { class: 'map' },
      element('figcaption', { class: 'faint' }, 'From above. Rings: truth. Filled shapes: what the robot believes.'),
    );
    const senses = element('div', { class: 'senses-row' });
    const head = element('div', { class: 'robot-head' }, this.choice, this.facts);
    middle.append(this.motion, element('div', { class: 'robot-views' }, camera, map), senses);
    words.append(head, this.#sheets(goTo));
    this.drawJoints = jointBars(joints);
    this.drawCamera = cameraPicture(camera);
    this.drawMap = surroundingsMap(map);
    this.drawSenses = sensesPanel(senses);
    this.plots = new PlotController(right, goTo);
  }

  /** Tabs for the log and the messages. @param {(seconds: number) => void} goTo */
  #sheets(goTo) {
    const log = element('div', { class: 'sheet', id: 'log-sheet' });
    const messages = element('div', { class: 'sheet', id: 'message-sheet' });
    const sheets = [log, messages];
    const tabs = ['Log', 'Messages'].map((name, i) =>
      button(name, i === 0 ? 'Log of the robot’s program (G)' : 'Messages on the wire (M)', () => show(i)),
    );
    tabs[0].id = 'log-tab';
    tabs[1].id = 'message-tab';
    const show = (/** @type {number} */ shown) => {
      sheets.forEach((sheet, i) => {
        sheet.hidden = i !== shown;
        tabs[i].setAttribute('aria-pressed', String(i === shown));
      });
    };
    this.showSheet = show;
    this.drawLog = logList(log, goTo);
    this.drawMessages = messageView(messages);
    show(0);
    return element('div', { class: 'sheets' }, element('div', { class: 'tabs' }, ...tabs), ...sheets);
  }

  /** Keyboard actions of this room. */
  get actions() {
    return [
      {
        keys: ['n', 'N'],
        shown: 'N',
        text: 'next robot',
        act: () => this.choose((this.watch.chosen + 1) % Math.max(1, this.choice.options.length)),
      },
      { keys: ['g', 'G'], shown: 'G', text: 'log', act: () => this.showSheet?.(0) },
      { keys: ['m', 'M'], shown: 'M', text: 'messages', act: () => this.showSheet?.(1) },
      { keys: ['h', 'H'], shown: 'H', text: 'hold or resume the curves', act: () => this.plots.hold() },
    ];
  }

  /** @param {number} robot index of the robot */
  choose(robot) {
    this.watch.chosen = robot;
    this.lastPicture = 0;
  }

  /** Forgets the subscription, because a new connection has none. */
  forget() {
    this.watch.forget();
  }

  /** @param {{robot: string, lines: string[], messages: Array<[number, string, string]>}} news */
  receive(news) {
    this.watch.receive(news);
  }

  /**
   * @param {Shown} shown
   * @param {TimeCursor} cursor
   * @param {number} now milliseconds
   */
  turn(shown, cursor, now) {
    if (now - this.lastPicture < PICTURE_MILLISECONDS) {
      return;
    }
    this.lastPicture = now;
    this.#listRobots(shown.scene?.robots ?? []);
    const moment = this.watch.moment(shown, cursor);
    if (moment) {
      this.#draw(moment, shown.tense === 'live');
    } else {
      setText(this.facts, 'There is no robot yet. Run an agent.');
    }
  }

  /** @param {RobotMoment} moment @param {boolean} isLive */
  #draw(moment, isLive) {
    const { frame, robot, thoughts, scene, model, seconds } = moment;
    const place = placeOf(frame, robot);
    setText(
      this.facts,
      `x ${fixed(place.x, 2)} m, y ${fixed(place.y, 2)} m, heading ${fixed(place.heading, 0)}°, ${place.stands ? 'standing' : 'lying'}`,
    );
    const { name, keyframe } = thoughts.motion;
    setText(this.motion, name ? `Motion ${name}, moving to keyframe ${keyframe}` : 'No motion is running');
    this.drawJoints(moment);
    this.drawMap(moment);
    this.drawCamera(thoughts.picture && readSenses(thoughts.picture.perceptors).seen, scene.robots[robot].team);
    const { exchange } = thoughts;
    this.drawSenses(
      exchange ? readSenses(exchange.perceptors) : NO_SENSES,
      exchange ? readOrders(exchange.effectors).said : [],
      model,
    );
    this.drawLog?.(thoughts.log, seconds);
    this.drawMessages?.(exchange);
    this.plots.draw(moment, isLive);
  }

  /** @param {readonly import('../live/state-frame.js').Player[]} robots */
  #listRobots(robots) {
    const names = robots.map(({ team, number }) => `${team} ${number}`.trim() || 'new robot');
    if ([...this.choice.options].map(({ text }) => text).join('\n') !== names.join('\n')) {
      setEntries(
        this.choice,
        names.map((name, i) => [String(i), name]),
      );
    }
    this.choice.hidden = names.length === 0;
    this.choice.value = String(Math.min(this.watch.chosen, names.length - 1));
  }
}
