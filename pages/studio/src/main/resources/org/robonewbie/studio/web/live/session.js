/** What this page knows of the running simulation: news and frames come in, what is to be shown goes out. No picture here. */
import { DrawingMemory } from '../state/robot/drawing-memory.js';
import { Smoothing } from '../state/smoothing.js';
import {
  initialState,
  withConnection,
  withDeeds,
  withFrame,
  withoutConnection,
  withRefusal,
  withScene,
} from '../state/studio-state.js';
import { TimeCursor } from '../state/time-cursor.js';
import { TrialGhost } from '../state/trial-ghost.js';
import { readFrame } from './state-frame.js';

/**
 * @typedef {object} Audience who hears of what is not part of the picture
 * @property {() => void} begun a simulation is there, perhaps another one than before
 * @property {(news: any) => void} telemetry
 * @property {(event: string, teams: {left: string, right: string}) => void} happened
 * @property {(mistake: {team: string, number: number, level: string, text: string}) => void} mistaken of a robot's program
 * @property {(sets: Record<string, import('../state/board-shapes.js').BoardShape[]>) => void} drawn for RoboViz
 * @property {(text: string) => void} note
 */

export class Session {
  #lastBytes = new Uint8Array();

  /**
   * @param {Audience} audience
   * @param {() => number} clock milliseconds
   */
  constructor(audience, clock = () => performance.now()) {
    this.audience = audience;
    this.clock = clock;
    this.state = initialState();
    this.cursor = new TimeCursor();
    this.smoothing = new Smoothing();
    this.ghost = new TrialGhost();
    /** What robots of the running simulation have drawn. */
    this.drawn = new DrawingMemory();
    /** Whether the picture must be drawn again. */
    this.stale = true;
    /** Whether the simulator waits to hear that its frame was seen. */
    this.owesAnswer = false;
  }

  touch() {
    this.stale = true;
  }

  /** @returns {import('../state/time-cursor.js').Shown} the moment that all rooms show */
  get shown() {
    return this.cursor.shown(this.state);
  }

  /** What robots have drawn at the moments around the shown one. */
  get drawings() {
    return this.cursor.recorded?.drawings ?? this.drawn;
  }

  get teams() {
    return this.state.scene?.teams ?? { left: '', right: '' };
  }

  opened() {
    this.#set(withConnection(this.state));
    this.audience.begun();
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

  /** @param {any} news a message of the simulator */
  told(news) {
    this.touch();
    if (news.kind === 'scene') {
      this.#set(withScene(this.state, news));
    } else if (news.kind === 'telemetry') {
      this.drawn.hear([...news.lines, ...news.drawings]);
      this.audience.telemetry(news);
    } else if (news.kind === 'undo') {
      this.#set(withDeeds(this.state, news));
    } else if (news.kind === 'board') {
      this.audience.drawn(news.sets);
    } else if (news.kind === 'mistake') {
      this.audience.mistaken(news);
    } else if (news.kind === 'event') {
      this.audience.happened(news.text, this.teams);
    } else {
      this.audience.note(news.text);
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
      this.ghost.hear(frame.cycle, scene, bytes);
      this.#set(withFrame(this.state, frame, now));
      this.smoothing.push(frame, now);
    }
  }

  /** Whether a frame says what the last one said: a world that is paused sends it each second. @param {ArrayBuffer} bytes */
  #repeats(bytes) {
    const [last, next] = [this.#lastBytes, new Uint8Array(bytes)];
    this.#lastBytes = next;
    return this.state.frame !== undefined && last.length === next.length && last.every((value, i) => value === next[i]);
  }

  /** Goes to another moment. @param {(cursor: TimeCursor) => void} move */
  travel(move) {
    move(this.cursor);
    this.touch();
  }

  /**
   * The robot at an index of the shown scene, whose posture at the shown moment can become a keyframe.
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

  /** @returns {import('../state/studio-state.js').StudioState} what the panels of the field show */
  get onPanels() {
    const { tense, scene, frame } = this.shown;
    const { state } = this;
    const { paused = false, speed = 1 } = state.frame ?? {};
    return tense === 'live' ? state : { ...state, scene, frame: frame && { ...frame, paused, speed }, goal: undefined };
  }

  /** @param {import('../state/studio-state.js').StudioState} state */
  #set(state) {
    this.state = state;
    this.touch();
  }
}
