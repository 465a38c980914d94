/** The motion room: connects editor, 3D view, timeline and panels. */
import { button, byId, element } from '../panels/elements.js';
import { posesOf, postureOfHinges } from '../state/motion/body.js';
import { atMark } from '../state/motion/marks.js';
import { sideCopied, timed, turned } from '../state/motion/edits.js';
import { posed, withKeyframeHere } from '../state/motion/editor-state.js';
import { mostTurned } from '../state/motion/posture.js';
import { Editor } from './editor.js';
import { filesPanel } from './files-panel.js';
import { jointPanel } from './joint-panel.js';
import { LimbController } from './limb-controller.js';
import { MotionFiles } from './motion-files.js';
import { MotionPicture } from './motion-picture.js';
import { MotionStage } from './motion-stage.js';
import { takeTyped } from './number-field.js';
import { ordersOf } from './orders.js';
import { stageOptions } from './stage-options.js';
import { takePosture } from './take-posture.js';
import { Timeline } from './timeline.js';
import { toolbar } from './toolbar.js';
import { transportBar } from './transport-bar.js';
import { tryPhysically } from './try-physically.js';

const DISK_MILLISECONDS = 2000;

/**
 * @typedef {object} Surroundings
 * @property {(text: string) => void} note
 * @property {import('../state/quality.js').Quality} quality
 * @property {() => {name: string, degrees: ArrayLike<number>} | undefined} robotOfRun the robot followed in the field
 * @property {string} [wanted] the motion to open first
 */

/** @param {Surroundings} surroundings */
export async function openMotionRoom(surroundings) {
  const files = new MotionFiles();
  const room = new MotionRoom(surroundings, files, await files.body());
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
    this.stale = true;
    this.editor = new Editor(body, files, { changed: () => this.touch(), note: surroundings.note });
    this.run = (/** @type {Promise<unknown>} */ work) =>
      void work.catch((error) => surroundings.note(problemText(error)));
    this.orders = ordersOf(this.editor, this.run);
    const place = byId('motion-room');
    const parts = partsOf(place);
    this.stage = new MotionStage(parts.picture, body, surroundings.quality);
    this.picture = new MotionPicture(this.stage, this.editor);
    const { options, hint, draw } = this.#options();
    parts.picture.append(hint, options, this.#conflict(), this.#originalRule());
    this.timeline = this.#timeline(parts.line);
    const take = takePosture(
      () => this.#takePosture(),
      () => this.#robotOfRun()?.name ?? '',
    );
    this.draws = [
      toolbar(parts.tools, this.editor, this.orders, take),
      filesPanel(parts.files, this.editor, this.run, this.orders),
      this.#transport(parts.bar),
      this.#joints(parts.joints),
      () => draw(this.editor.state),
    ];
    this.pointer = this.#pointerController();
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
      apply: (edit) => editor.apply(edit),
      goTo: (mark) => editor.apply((state) => atMark(state, mark)),
    });
  }

  /** @param {HTMLElement} place */
  #transport(place) {
    const { editor, run, surroundings } = this;
    return transportBar(place, editor, this.orders, {
      setTime: (millis) => editor.apply((state) => timed(state, state.last, millis)),
      note: surroundings.note,
      tryPhysically: (start) => (takeTyped(), run(tryPhysically(editor, start))),
    });
  }

  /** @param {HTMLElement} place */
  #joints(place) {
    const { editor } = this;
    const draw = jointPanel(place, {
      turn: (joint, degrees, gesture) => editor.apply((state) => turned(state, joint, degrees, gesture)),
      choose: (joint) => editor.apply((state) => ({ ...state, joint })),
      note: this.surroundings.note,
      copySide: (side) => editor.apply((state) => sideCopied(state, side)),
      setSymmetric: (symmetric) => editor.apply((state) => ({ ...state, symmetric })),
    });
    return () => draw(editor.state);
  }

  #pointerController() {
    const { editor } = this;
    return new LimbController(this.stage, {
      now: () => (editor.state.watching || editor.state.playing ? undefined : this.posedNow()),
      pose: (posture, from, torso) => {
        this.picture.heldTorso = torso;
        editor.apply((state) => ({
          ...posed(state, posture, 'Drag a limb', from.gesture),
          joint: mostTurned(from.posture, posture, state.joint),
        }));
      },
      released: () => {
        this.picture.heldTorso = undefined;
        this.touch();
      },
      over: (link) => {
        this.stale ||= link !== this.picture.over;
        this.picture.over = link;
      },
      changed: () => this.touch(),
    });
  }

  /** @param {HTMLElement} place */
  #lookAtDisk(place) {
    if (!place.hidden && !document.hidden && !this.pointer.grip) {
      this.editor.lookAtDisk().catch(() => {});
    }
  }

  touch() {
    this.stale = true;
  }

  /** The robot of the open motion. */
  get body() {
    return this.editor.state.body;
  }

  /** @param {'light' | 'dark'} theme */
  setTheme(theme) {
    this.stage.setTheme(theme);
    this.touch();
  }

  /** Key actions of this room. */
  get actions() {
    return this.orders
      .filter(({ keys }) => keys.length > 0)
      .map((order) => ({ ...order, text: order.hint || order.name.toLowerCase() }));
  }

  /**
   * Redraws if anything has changed.
   *
   * @param {number} seconds since the last call
   */
  turn(seconds) {
    this.editor.advance(1000 * seconds);
    if (!this.stale) {
      return;
    }
    this.stale = false;
    this.picture.draw();
    this.stale = this.stage.draw(seconds) || this.stale;
    this.draws.forEach((draw) => draw());
    this.timeline.draw(this.editor.state, this.editor.marks, this.editor.lag);
    byId('disk-conflict').hidden = !this.editor.conflict;
    byId('original-rule').hidden = !this.editor.isOriginal;
  }

  /** Returns the displayed posture with the pose of its torso. */
  posedNow() {
    return this.picture.posedNow();
  }

  /** @param {readonly number[]} posture @param {ArrayLike<number>} torso */
  posesOf(posture, torso) {
    return posesOf(this.body, posture, torso);
  }

  #options() {
    return stageOptions({
      setGhosts: (ghosts) => this.editor.apply((state) => ({ ...state, ghosts })),
      setUpright: (on) => this.editor.apply((state) => ({ ...state, manner: on ? 'upright' : 'soles' })),
      setWatching: (watching) => this.editor.apply((state) => ({ ...state, watching, playing: false })),
      look: (azimuthDegrees, elevationDegrees) => this.#look(azimuthDegrees, elevationDegrees),
    });
  }

  /** @param {number} azimuthDegrees @param {number} elevationDegrees */
  #look(azimuthDegrees, elevationDegrees) {
    this.stage.home();
    this.stage.cameraController.view = { ...this.stage.cameraController.view, azimuthDegrees, elevationDegrees };
    this.touch();
  }

  #conflict() {
    const { editor, run } = this;
    const reload = () => run(editor.reload());
    return element(
      'div',
      { id: 'disk-conflict', class: 'panel centred', role: 'alert', hidden: '' },
      element('p', {}, 'This file was changed by another program and also has unsaved changes here.'),
      button('Load theirs', 'Undo restores your version', reload, { id: 'load-theirs' }),
      button('Keep mine', 'The next save replaces the file', () => editor.keepMine(), { id: 'keep-mine' }),
    );
  }

  #originalRule() {
    const { editor } = this;
    const old = () => editor.decideRule(true);
    const now = () => editor.decideRule(false);
    return element(
      'div',
      { id: 'original-rule', class: 'panel centred', role: 'status', hidden: '' },
      element(
        'p',
        {},
        'This motion seems to have been written for RoboNewbie 1.1, which played short keyframes differently.',
      ),
      button('Play it as RoboNewbie 1.1 did', 'Adds // play: 1.1 at the top of the file', old, { id: 'play-original' }),
      button('Leave it as it is', 'Agents play it like any other motion', now, { id: 'play-usual' }),
    );
  }

  /** Returns the robot followed in the field, if it has the joints of the motion's robot. */
  #robotOfRun() {
    const robot = this.surroundings.robotOfRun();
    return robot?.degrees.length === this.body.model.hinges.length ? robot : undefined;
  }

  #takePosture() {
    const robot = this.#robotOfRun();
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
    ? 'The studio is not responding. Your work is still on this page; save it when the simulator is running again.'
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
    picture: part('motion-stage', 'Robot. Drag its limbs.'),
    joints: part('motion-joints', 'Joints'),
    bar: part('motion-transport', 'Play and try'),
    line: part('motion-timeline', 'Timeline. The left and right arrow keys select a keyframe.'),
  };
}
