/** The room in which motions are shaped: brings editor, picture, timeline and panels together. */
import { button, byId, element } from '../panels/elements.js';
import { balanceOf } from '../state/motion/balance.js';
import { bodyOf, placed, posesOf, postureOfHinges } from '../state/motion/body.js';
import { sideCopied, timed, turned } from '../state/motion/edits.js';
import {
  atTime,
  framesOf,
  isOnKeyframe,
  posed,
  postureNow,
  selected,
  withKeyframeHere,
} from '../state/motion/editor-state.js';
import { mostTurned } from '../state/motion/posture.js';
import { Editor } from './editor.js';
import { filesPanel } from './files-panel.js';
import { jointPanel } from './joint-panel.js';
import { LimbHand } from './limb-hand.js';
import { MotionFiles } from './motion-files.js';
import { MotionStage } from './motion-stage.js';
import { takeTyped } from './number-field.js';
import { ordersOf } from './orders.js';
import { stageOptions } from './stage-options.js';
import { Timeline } from './timeline.js';
import { toolbar } from './toolbar.js';
import { transportBar } from './transport-bar.js';

const DISK_MILLISECONDS = 2000;

/**
 * @typedef {object} Surroundings
 * @property {string} token
 * @property {(text: string) => void} note
 * @property {import('../state/quality.js').Quality} quality
 * @property {() => {name: string, degrees: ArrayLike<number>} | undefined} robotOfRun the robot that is followed in the field
 * @property {string} [wanted] the motion to begin with
 */

/** @param {Surroundings} surroundings */
export async function openMotionRoom(surroundings) {
  const files = new MotionFiles(surroundings.token);
  const room = new MotionRoom(surroundings, files, bodyOf(await files.robot()));
  await room.editor.begin(surroundings.wanted);
  return room;
}

class MotionRoom {
  /**
   * @param {Surroundings} surroundings
   * @param {MotionFiles} files
   * @param {import('../state/motion/body.js').Body} body
   */
  constructor(surroundings, files, body) {
    this.surroundings = surroundings;
    this.body = body;
    this.stale = true;
    this.over = -1;
    /** @type {number[] | undefined} the torso while a limb is dragged */
    this.heldTorso = undefined;
    this.editor = new Editor(body, files, { changed: () => this.touch(), note: surroundings.note });
    this.run = (/** @type {Promise<unknown>} */ work) =>
      void work.catch((error) => surroundings.note(problemText(error)));
    this.orders = ordersOf(this.editor, this.run);
    const place = byId('motion-room');
    const parts = partsOf(place);
    this.stage = new MotionStage(parts.picture, body, surroundings.quality);
    parts.picture.append(this.#options(), this.#conflict());
    this.timeline = this.#timeline(parts.line);
    this.draws = [
      toolbar(parts.tools, this.editor, this.orders),
      filesPanel(parts.files, this.editor, this.run, this.orders),
      this.#transport(parts.bar),
      this.#joints(parts.joints),
    ];
    this.hand = this.#hand();
    new ResizeObserver(() => {
      this.stage.resize();
      this.touch();
    }).observe(place);
    setInterval(() => this.#lookAtDisk(place), DISK_MILLISECONDS);
  }

  /** @param {HTMLElement} place */
  #timeline(place) {
    const { editor } = this;
    return new Timeline(place, {
      select: (index, extending) => editor.apply((state) => selected({ ...state, trial: undefined }, index, extending)),
      scrub: (time) => editor.apply((state) => ({ ...atTime(state, time), playing: false })),
      setTime: (index, millis, gesture) => editor.apply((state) => timed(state, index, millis, gesture)),
    });
  }

  /** @param {HTMLElement} place */
  #transport(place) {
    const { editor, run, surroundings } = this;
    return transportBar(place, editor, this.orders, {
      setTime: (millis) => editor.apply((state) => timed(state, state.last, millis)),
      note: surroundings.note,
      tryPhysically: (start) => (takeTyped(), run(editor.tryPhysically(start))),
      takePosture: () => this.#takePosture(),
      robotOfRun: () => surroundings.robotOfRun()?.name ?? '',
    });
  }

  /** @param {HTMLElement} place */
  #joints(place) {
    const { editor } = this;
    const draw = jointPanel(place, this.body, {
      turn: (joint, degrees, gesture) => editor.apply((state) => turned(state, joint, degrees, gesture)),
      choose: (joint) => editor.apply((state) => ({ ...state, joint })),
      note: this.surroundings.note,
      copySide: (side) => editor.apply((state) => sideCopied(state, side)),
      setSymmetric: (symmetric) => editor.apply((state) => ({ ...state, symmetric })),
    });
    return () => draw(editor.state);
  }

  #hand() {
    const { editor } = this;
    return new LimbHand(this.stage, {
      now: () => (editor.state.trial || editor.state.playing ? undefined : this.posedNow()),
      pose: (posture, from, torso) => {
        this.heldTorso = torso;
        editor.apply((state) => ({
          ...posed(state, posture, 'Drag a limb', from.gesture),
          joint: mostTurned(from.posture, posture, state.joint),
        }));
      },
      released: () => {
        this.heldTorso = undefined;
        this.touch();
      },
      over: (link) => {
        this.stale ||= link !== this.over;
        this.over = link;
      },
      changed: () => this.touch(),
    });
  }

  /** @param {HTMLElement} place */
  #lookAtDisk(place) {
    if (!place.hidden && !document.hidden && !this.hand.grip) {
      this.editor.lookAtDisk().catch(() => {});
    }
  }

  touch() {
    this.stale = true;
  }

  /** @param {'light' | 'dark'} theme */
  setTheme(theme) {
    this.stage.setTheme(theme);
    this.touch();
  }

  /** What keys do here. */
  get deeds() {
    return this.orders
      .filter(({ keys }) => keys.length > 0)
      .map((order) => ({ ...order, text: order.hint || order.name.toLowerCase() }));
  }

  /**
   * Draws if anything has changed.
   *
   * @param {number} seconds since the last turn
   */
  turn(seconds) {
    this.editor.advance(1000 * seconds);
    if (!this.stale) {
      return;
    }
    this.stale = false;
    this.#drawPicture();
    this.stale = this.stage.draw(seconds) || this.stale;
    this.draws.forEach((draw) => draw());
    this.timeline.draw(this.editor.state, this.editor.marks);
    byId('disk-conflict').hidden = !this.editor.conflict;
  }

  /** The posture that is shown and where its torso is. */
  posedNow() {
    const posture = postureNow(this.editor.state);
    return { posture, torso: this.heldTorso ?? placed(this.body, posture, this.editor.state.manner) };
  }

  /** @param {readonly number[]} posture @param {ArrayLike<number>} torso */
  posesOf(posture, torso) {
    return posesOf(this.body, posture, torso);
  }

  #drawPicture() {
    const { state } = this.editor;
    if (state.trial) {
      this.#drawTrial(state.trial, state.time);
      return;
    }
    const { posture, torso } = this.posedNow();
    const poses = this.posesOf(posture, torso);
    this.stage.show(this.stage.figure(posture, torso), this.#ghosts(torso));
    this.stage.marker.setBalance(balanceOf(this.body, poses));
    this.stage.marker.frameLink(state.playing ? -1 : this.over, poses);
  }

  /** @param {{frames: readonly number[][], frameSeconds: number}} trial @param {number} time milliseconds */
  #drawTrial({ frames, frameSeconds }, time) {
    const frame = frames[Math.min(frames.length - 1, Math.round(time / 1000 / frameSeconds))];
    const torso = frame.slice(0, 7);
    this.stage.desk.view = { ...this.stage.desk.view, target: [torso[0], torso[1], 0.31] };
    this.stage.show({ torso, hinges: frame.slice(7) }, []);
    this.stage.marker.setBalance(undefined);
    this.stage.marker.frameLink(-1, new Float64Array());
  }

  /** The keyframes before and after, if they shall be seen. @param {number[]} torso */
  #ghosts(torso) {
    const { state } = this.editor;
    const frames = framesOf(state);
    if (!state.ghosts || state.playing || this.heldTorso) {
      return [];
    }
    const next = isOnKeyframe(state) ? state.last + 1 : state.last;
    return [state.last - 1, next]
      .filter((index) => index >= 0 && index < frames.length)
      .map((index) => frames[index].degrees)
      .map((posture) => this.stage.figure(posture, placed(this.body, posture, state.manner) ?? torso));
  }

  #options() {
    return stageOptions({
      setGhosts: (ghosts) => this.editor.apply((state) => ({ ...state, ghosts })),
      setUpright: (on) => this.editor.apply((state) => ({ ...state, manner: on ? 'upright' : 'soles' })),
      look: (azimuthDegrees, elevationDegrees) => this.#look(azimuthDegrees, elevationDegrees),
    });
  }

  /** @param {number} azimuthDegrees @param {number} elevationDegrees */
  #look(azimuthDegrees, elevationDegrees) {
    this.stage.home();
    this.stage.desk.view = { ...this.stage.desk.view, azimuthDegrees, elevationDegrees };
    this.touch();
  }

  #conflict() {
    const { editor, run } = this;
    const reload = button('Load theirs', 'Undo brings yours back', () => run(editor.reload()), { id: 'load-theirs' });
    const mine = button('Keep mine', 'The next save replaces the file', () => editor.keepMine(), { id: 'keep-mine' });
    const panel = element(
      'div',
      { id: 'disk-conflict', class: 'panel', role: 'alert' },
      element('p', {}, 'Another program has changed this file, and so have you.'),
      reload,
      mine,
    );
    panel.hidden = true;
    return panel;
  }

  #takePosture() {
    const robot = this.surroundings.robotOfRun();
    if (robot) {
      const posture = postureOfHinges(this.body, robot.degrees);
      this.editor.apply((state) =>
        posed({ ...withKeyframeHere(state), symmetric: false }, posture, `Posture of ${robot.name}`),
      );
    }
  }
}

/** @param {Error} error */
function problemText(error) {
  return error instanceof TypeError
    ? 'The studio does not answer. Your work stays in this page; save it when the simulator runs again.'
    : error.message;
}

/** @param {HTMLElement} room */
function partsOf(room) {
  const part = (/** @type {string} */ id, /** @type {string} */ label) => {
    const made = element('section', { id, 'aria-label': label });
    room.append(made);
    return made;
  };
  return {
    tools: part('motion-tools', 'Motion'),
    files: part('motion-files', 'Motions and postures'),
    picture: part('motion-stage', 'The robot; drag its limbs'),
    joints: part('motion-joints', 'Joints'),
    bar: part('motion-transport', 'Play and try'),
    line: part('motion-timeline', 'Timeline. The left and right arrow keys choose a keyframe.'),
  };
}
