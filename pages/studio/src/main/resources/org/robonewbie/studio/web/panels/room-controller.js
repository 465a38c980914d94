/** Loads each room when it is first entered, so that startup does not wait for unused rooms. */

import { byId, element } from './elements.js';

/**
 * @typedef {import('./rooms.js').RoomName} RoomName
 * @typedef {{actions: import('./keys.js').Action[], mouse: string[][]}} Keys
 */

const MOTION_MOUSE = [
  ['Drag a limb', 'turn its joints'],
  ['Shift, drag', 'the whole arm or leg follows'],
  ['Drag the torso', 'the feet stay where they are'],
  ['Drag the ground', 'turn the view'],
  ['Drag a keyframe', 'change its time and shift all later ones; with Alt, they stay in place'],
  ['Shift, Ctrl, click', 'select several keyframes'],
  ['Drag over joints', 'select what is in the box'],
  ['Drag a point of a curve', 'change the angle'],
  ['Wheel', 'zoom the timeline; with Shift, scroll it'],
];

const ROBOT_MOUSE = [
  ['Click a curve', 'all rooms show this moment'],
  ['Drag over a curve', 'zoom in; H resumes'],
  ['Click a log time', 'all rooms show this moment'],
  ['Drag an edge', 'resize the panels'],
];

const REPLAY_MOUSE = [
  ['Drag the time line', 'go to any moment'],
  ['Drag the ground', 'turn the view'],
  ['Click a robot', 'follow it'],
];

const PROGRAM_MOUSE = [
  ['Drag the edge', 'resize the program'],
  ['Double-click an edge', 'restore the default layout'],
];

const MOTION_STYLES = ['motion.css', 'motion-bars.css', 'motion-timeline.css', 'motion-tracks.css'];
const PROGRAM_STYLES = ['program.css', 'first-minute.css'];
const ROBOT_STYLES = ['vendor/uplot/uplot.min.css', 'robot.css', 'robot-sheets.css'];

export class RoomController {
  /**
   * @param {object} surroundings
   * @param {(text: string) => void} surroundings.note
   * @param {() => void} surroundings.clearErrors dismisses the errors shown on top of the 3D view
   * @param {() => import('../state/quality.js').Quality} surroundings.quality
   * @param {(command: object) => void} surroundings.send
   * @param {() => void} surroundings.goLive returns to the present
   * @param {(starting: string) => void} surroundings.announce shows what is about to replace the scene
   * @param {() => boolean} surroundings.hasClock whether the clock can be paused
   * @param {(seconds: number) => void} surroundings.goTo shows a moment of the running simulation
   * @param {() => import('../field/camera-controller.js').CameraController} surroundings.camera returns the field's camera
   * @param {() => readonly import('../live/state-frame.js').Player[]} surroundings.robots returns the robots currently on the pitch
   * @param {() => boolean} surroundings.isPitchEmpty whether the pitch has no robots and puppets can join
   * @param {() => {name: string, degrees: ArrayLike<number>} | undefined} surroundings.robotOfRun
   */
  constructor(surroundings) {
    this.surroundings = surroundings;
    /** @type {Awaited<ReturnType<typeof import('../motion/motion-room.js').openMotionRoom>> | undefined} */
    this.motion = undefined;
    /** @type {Awaited<ReturnType<typeof import('../replay/replay-room.js').openReplayRoom>> | undefined} */
    this.replay = undefined;
    /** @type {import('../robot/robot-room.js').RobotRoom | undefined} */
    this.robot = undefined;
    /** @type {Awaited<ReturnType<typeof import('../program/program-room.js').openProgramRoom>> | undefined} */
    this.program = undefined;
    /** @type {RoomName} */
    this.here = 'field';
    /** Rooms that are loading: the field until it is known whether a newcomer begins in another room. @type {Set<RoomName>} */
    this.opening = new Set(['field']);
  }

  /** Called when the first room has been chosen. */
  chosen() {
    this.opening.delete('field');
    this.#showBusy();
  }

  /** @param {RoomName} room */
  async enter(room) {
    this.motion?.touch();
    if (room !== this.here && (room === 'program' || this.here === 'program')) {
      this.forget();
    }
    this.here = room;
    const isOpen = room === 'field' || this[room] !== undefined || this.opening.has(room);
    if (!isOpen) {
      this.opening.add(room);
      this.#showBusy();
      await this.#open(room);
      this.opening.delete(room);
    }
    this.#showBusy();
  }

  /** Marks the page as busy while a room is loading, for example for screen readers. */
  #showBusy() {
    document.body.ariaBusy = String(this.opening.size > 0);
  }

  /** @param {Exclude<RoomName, 'field'>} room */
  async #open(room) {
    try {
      await {
        motion: () => this.#openMotion(),
        replay: () => this.#openReplay(),
        robot: () => this.#openRobot(),
        program: () => this.#openProgram(),
      }[room]();
    } catch (error) {
      this.surroundings.note(`This room cannot be opened: ${/** @type {Error} */ (error).message}`);
    }
  }

  /** @returns {boolean} whether closing the page would lose work */
  get isAtRisk() {
    return this.motion?.editor.isAtRisk === true || this.program?.isAtRisk === true;
  }

  /** Discards the telemetry subscriptions. Call after the simulator has changed or another room has replaced them. */
  forget() {
    this.robot?.forget();
    this.program?.forget();
  }

  /** @param {any} news telemetry of robots */
  receive(news) {
    this.robot?.receive(news);
    this.program?.receive(news);
  }

  /** @param {RoomName} room @param {Keys} field @returns {Keys} the key and mouse actions of a room */
  keys(room, field) {
    if (room === 'motion') {
      return { actions: this.motion?.actions ?? [], mouse: MOTION_MOUSE };
    }
    if (room === 'robot') {
      const own = this.robot?.actions ?? [];
      const others = field.actions.filter(({ shown }) => !own.some((action) => action.shown === shown));
      return { actions: [...own, ...others], mouse: [...field.mouse, ...ROBOT_MOUSE] };
    }
    if (room === 'program') {
      return {
        actions: [...(this.program?.actions ?? []), ...field.actions],
        mouse: [...field.mouse, ...PROGRAM_MOUSE],
      };
    }
    return room === 'replay' ? { actions: this.replay?.actions ?? [], mouse: REPLAY_MOUSE } : field;
  }

  async #openMotion() {
    const [{ openMotionRoom }] = await Promise.all([import('../motion/motion-room.js'), loadStyles(MOTION_STYLES)]);
    const { quality, ...others } = this.surroundings;
    const wanted = decodeURIComponent(location.hash.split('/')[1] ?? '') || undefined;
    this.motion = await openMotionRoom({ ...others, quality: quality(), wanted });
    this.motion.setTheme(document.documentElement.dataset.theme === 'dark' ? 'dark' : 'light');
  }

  async #openProgram() {
    const [{ openProgramRoom }] = await Promise.all([import('../program/program-room.js'), loadStyles(PROGRAM_STYLES)]);
    this.program = await openProgramRoom(this.surroundings);
  }

  async #openRobot() {
    const [{ RobotRoom }] = await Promise.all([import('../robot/robot-room.js'), loadStyles(ROBOT_STYLES)]);
    this.robot = new RobotRoom(this.surroundings);
  }

  async #openReplay() {
    const place = byId('recordings');
    place.hidden = false;
    place.replaceChildren(element('p', { class: 'faint' }, 'Loading the recordings…'));
    const { openReplayRoom } = await import('../replay/replay-room.js');
    this.replay = await openReplayRoom(this.surroundings);
  }
}

/** Loads the style sheets of a room, in order. @param {readonly string[]} sheets */
function loadStyles(sheets) {
  const loads = sheets.map((href) => {
    const link = element('link', { rel: 'stylesheet', href });
    document.head.append(link);
    return new Promise((done, failed) => {
      link.addEventListener('load', done);
      link.addEventListener('error', () => failed(new Error(`${href} is missing. Reload the page.`)));
    });
  });
  return Promise.all(loads);
}
