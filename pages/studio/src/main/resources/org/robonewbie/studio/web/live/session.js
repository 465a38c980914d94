/** The page's view of the running simulation: receives messages and frames, and provides the state to display. Independent of rendering. */
import { DrawingMemory } from '../state/robot/drawing-memory.js';
import { Smoothing } from '../state/smoothing.js';
import {
  initialState,
  withConnection,
  withActions,
  withFrame,
  withoutConnection,
  withRefusal,
  withScene,
  withStarting,
} from '../state/studio-state.js';
import { TimeCursor } from '../state/time-cursor.js';
import { TrialGhost } from '../state/trial-ghost.js';
import { readFrame } from './state-frame.js';

/**
 * @typedef {object} SessionListener receives events that are not part of the picture
 * @property {() => void} begun called when a simulation is connected, possibly a different one
 * @property {(news: any) => void} telemetry
 * @property {(event: string, teams: {left: string, right: string}) => void} happened
 * @property {(mistake: {team: string, number: number, level: string, text: string}) => void} diagnostic an error or warning from a robot's
 *     program
 * @property {(sets: Record<string, import('../state/board-shapes.js').BoardShape[]>) => void} drawn receives the changed sets of RoboViz
 *     shapes
 * @property {(text: string) => void} note
 */

export class Session {
  #lastBytes = new Uint8Array();

  /**
   * @param {SessionListener} listener
   * @param {() => number} clock milliseconds
   */
  constructor(listener, clock = () => performance.now()) {
    this.listener = listener;
    this.clock = clock;
    this.state = initialState();
    this.cursor = new TimeCursor();
    this.smoothing = new Smoothing();
    this.ghost = new TrialGhost();
    /** The robots' drawings in the running simulation. */
    this.drawn = new DrawingMemory();
    /** Whether the picture must be redrawn. */
    this.stale = true;
    /** Whether the simulator is waiting for this page to acknowledge a frame. */
    this.owesAnswer = false;
  }

  touch() {
    this.stale = true;
  }

  /** @returns {import('../state/time-cursor.js').Shown} the moment shown in all rooms */
  get shown() {
    return this.cursor.shown(this.state);
  }

  /** The robots' drawings around the displayed moment. */
  get drawings() {
    return this.cursor.recorded?.drawings ?? this.drawn;
  }

  get teams() {
    return this.state.scene?.teams ?? { left: '', right: '' };
  }

  opened() {
    this.#set(withConnection(this.state));
    this.listener.begun();
    this.cursor.restart();
    this.drawn = new DrawingMemory();
    this.smoothing.clear();
  }

  lost() {
    this.#set(withoutConnection(this.state));
    this.owesAnswer = false;
  }

  /** @param {string} reason */
  refused(reason) {
    this.#set(withRefusal(this.state, reason));
  }

  /** @param {any} news message from the simulator */
  messageArrived(news) {
    this.touch();
    if (news.kind === 'scene') {
      this.#set(withScene(this.state, news));
    } else if (news.kind === 'telemetry') {
      this.drawn.receive([...news.lines, ...news.drawings]);
      this.listener.telemetry(news);
    } else if (news.kind === 'undo') {
      this.#set(withActions(this.state, news));
    } else if (news.kind === 'board') {
      this.listener.drawn(news.sets);
    } else if (news.kind === 'mistake') {
      this.listener.diagnostic(news);
    } else if (news.kind === 'event') {
      this.listener.happened(news.text, this.teams);
    } else {
      this.listener.note(news.text);
    }
  }

  /** @param {string} starting description of what is about to replace the scene; empty if nothing is */
  announce(starting) {
    if (starting !== this.state.starting) {
      this.#set(withStarting(this.state, starting));
    }
  }

  /** @param {ArrayBuffer} bytes */
  frameArrived(bytes) {
    this.owesAnswer = true;
    const { scene } = this.state;
    const frame = scene && readFrame(bytes, scene);
    if (frame && !this.#repeats(bytes)) {
      const now = this.clock();
      this.cursor.history.push(frame.cycle, scene, bytes);
      this.ghost.receive(frame.cycle, scene, bytes);
      this.#set(withFrame(this.state, frame, now));
      this.smoothing.push(frame, now);
    }
  }

  /**
   * Returns whether a frame equals the previous one, which is repeated every second while the world is paused. @param {ArrayBuffer} bytes
   */
  #repeats(bytes) {
    const [last, next] = [this.#lastBytes, new Uint8Array(bytes)];
    this.#lastBytes = next;
    return this.state.frame !== undefined && last.length === next.length && last.every((value, i) => value === next[i]);
  }

  /** Moves the time cursor. @param {(cursor: TimeCursor) => void} move */
  travel(move) {
    move(this.cursor);
    this.touch();
  }

  /**
   * Returns the robot at an index in the displayed scene, with its posture at the displayed moment.
   *
   * @param {number} index
   * @returns {{name: string, degrees: ArrayLike<number>} | undefined}
   */
  robot(index) {
    const { tense, scene, frame } = this.shown;
    const player = scene?.robots[index];
    const robot = frame?.robots[index];
    const isThere = tense === 'recorded' || this.state.connection === 'live';
    return player && robot && isThere
      ? { name: `${player.team} ${player.number}`.trim() || 'the robot', degrees: robot.degrees }
      : undefined;
  }

  /** @returns {import('../state/studio-state.js').StudioState} state for the field's panels */
  get onPanels() {
    const { tense, scene, frame } = this.shown;
    const { state } = this;
    const { paused = false, speed = 1 } = state.frame ?? {};
    const isRecorded = tense === 'recorded';
    return tense === 'live'
      ? state
      : { ...state, scene, frame: frame && { ...frame, paused, speed }, goal: undefined, isRecorded };
  }

  /** @param {import('../state/studio-state.js').StudioState} state */
  #set(state) {
    this.state = state;
    this.touch();
  }
}
