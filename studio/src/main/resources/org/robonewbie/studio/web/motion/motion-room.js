/** The room in which motions are shaped: brings editor, picture, timeline and panels together. */
import { button, byId, element } from '../panels/elements.js';
import { balanceOf } from '../state/motion/balance.js';
import { bodyOf, placed, posesOf, postureOfHinges } from '../state/motion/body.js';
import { sideCopied, timed, turned } from '../state/motion/edits.js';
import { atTime, framesOf, isOnKeyframe, posed, postureNow, selected, withKeyframeHere } from '../state/motion/editor-state.js';
import { Editor } from './editor.js';
import { filesPanel } from './files-panel.js';
import { jointPanel } from './joint-panel.js';
import { LimbHand } from './limb-hand.js';
import { MotionFiles } from './motion-files.js';
import { MotionStage } from './motion-stage.js';
import { ordersOf } from './orders.js';
import { Timeline } from './timeline.js';
import { toolbar, transportBar } from './toolbar.js';

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
    const place = byId('motion-room');
    const part = (/** @type {string} */ id, /** @type {string} */ label) => {
      const made = element('section', { id, 'aria-label': label });
      place.append(made);
      return made;
    };
    const run = (/** @type {Promise<unknown>} */ work) => void work.catch((error) => surroundings.note(problemText(error)));
    this.orders = ordersOf(this.editor, run);
    const tools = part('motion-tools', 'Motion');
    const fileList = part('motion-files', 'Motions and postures');
    const picture = part('motion-stage', 'The robot; drag its limbs');
    const joints = part('motion-joints', 'Joints');
    const bar = part('motion-transport', 'Play and try');
    const line = part('motion-timeline', 'Timeline. The left and right arrow keys choose a keyframe.');
    this.stage = new MotionStage(picture, body, surroundings.quality);
    picture.append(this.#options(), this.#conflict(run));
    this.timeline = new Timeline(line, {
      select: (index, extending) => this.editor.apply((state) => selected({ ...state, trial: undefined }, index, extending)),
      scrub: (time) => this.editor.apply((state) => ({ ...atTime(state, time), playing: false })),
      setTime: (index, millis, gesture) => this.editor.apply((state) => timed(state, index, millis, gesture)),
    });
    this.draws = [
      toolbar(tools, this.editor, this.orders),
      filesPanel(fileList, this.editor, run, this.orders),
      transportBar(bar, this.editor, this.orders, {
        setTime: (millis) => Number.isFinite(millis) && this.editor.apply((state) => timed(state, state.last, millis)),
        tryPhysically: (start) => run(this.editor.tryPhysically(start)),
        takePosture: () => this.#takePosture(),
        robotOfRun: () => surroundings.robotOfRun()?.name ?? '',
      }),
    ];
    const drawJoints = jointPanel(joints, body, {
      turn: (joint, degrees, gesture) => this.editor.apply((state) => turned(state, joint, degrees, gesture)),
      choose: (joint) => this.editor.apply((state) => ({ ...state, joint })),
      copySide: (side) => this.editor.apply((state) => sideCopied(state, side)),
      setSymmetric: (symmetric) => this.editor.apply((state) => ({ ...state, symmetric })),
    });
    this.draws.push(() => drawJoints(this.editor.state));
    this.hand = new LimbHand(this.stage, {
      now: () => (this.editor.state.trial || this.editor.state.playing ? undefined : this.posedNow()),
      pose: (posture, gesture, torso) => {
        this.heldTorso = torso;
        this.editor.apply((state) => posed(state, posture, 'Drag a limb', gesture));
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
    new ResizeObserver(() => {
      this.stage.resize();
      this.touch();
    }).observe(place);
    setInterval(() => {
      if (!place.hidden && !document.hidden && !this.hand.grip) {
        this.editor.lookAtDisk().catch(() => {});
      }
    }, DISK_MILLISECONDS);
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
    return this.orders.filter(({ keys }) => keys.length > 0).map((order) => ({ ...order, text: order.hint || order.name.toLowerCase() }));
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
    const { trial } = state;
    if (trial) {
      const index = Math.min(trial.frames.length - 1, Math.round(state.time / 1000 / trial.frameSeconds));
      const torso = trial.frames[index].slice(0, 7);
      this.stage.desk.view = { ...this.stage.desk.view, target: [torso[0], torso[1], 0.31] };
      this.stage.show({ torso, hinges: trial.frames[index].slice(7) }, []);
      this.stage.marker.setBalance(undefined);
      this.stage.marker.frameLink(-1, new Float64Array());
      return;
    }
    const { posture, torso } = this.posedNow();
    const poses = this.posesOf(posture, torso);
    this.stage.show(this.stage.figure(posture, torso), this.#ghosts(torso));
    this.stage.marker.setBalance(balanceOf(this.body, poses));
    this.stage.marker.frameLink(state.playing ? -1 : this.over, poses);
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
    const ghosts = element('input', { type: 'checkbox', id: 'ghosts', checked: '' });
    ghosts.addEventListener('change', () => this.editor.apply((state) => ({ ...state, ghosts: ghosts.checked })));
    const upright = element('input', { type: 'checkbox', id: 'upright' });
    upright.addEventListener('change', () => this.editor.apply((state) => ({ ...state, manner: upright.checked ? 'upright' : 'soles' })));
    const front = button('Front', 'Look from the front', () => this.#look(62, 12));
    const side = button('Side', 'Look from the side', () => this.#look(0, 8));
    const hint = element('p', { class: 'hint' }, 'Drag a limb · Shift: whole arm or leg follows · drag the torso: feet stay');
    return element(
      'div',
      { class: 'stage-options' },
      hint,
      element('label', { class: 'check', title: 'Shows the keyframes before (blue) and after (orange)' }, ghosts, 'Ghosts'),
      element('label', { class: 'check', title: 'Keeps the torso upright instead of laying the lower sole flat on the ground' }, upright, 'Torso upright'),
      front,
      side,
    );
  }

  /** @param {number} azimuthDegrees @param {number} elevationDegrees */
  #look(azimuthDegrees, elevationDegrees) {
    this.stage.home();
    this.stage.desk.view = { ...this.stage.desk.view, azimuthDegrees, elevationDegrees };
    this.touch();
  }

  /** @param {(work: Promise<unknown>) => void} run */
  #conflict(run) {
    const reload = button('Load theirs', 'Undo brings yours back', () => run(this.editor.reload()));
    const mine = button('Keep mine', 'The next save replaces the file', () => this.editor.keepMine());
    reload.id = 'load-theirs';
    mine.id = 'keep-mine';
    const panel = element('div', { id: 'disk-conflict', class: 'panel', role: 'alert' }, element('p', {}, 'Another program has changed this file, and so have you.'), reload, mine);
    panel.hidden = true;
    return panel;
  }

  #takePosture() {
    const robot = this.surroundings.robotOfRun();
    if (robot) {
      const posture = postureOfHinges(this.body, robot.degrees);
      this.editor.apply((state) => posed({ ...withKeyframeHere(state), symmetric: false }, posture, `Posture of ${robot.name}`));
    }
  }
}

/** @param {Error} error */
function problemText(error) {
  return error instanceof TypeError ? 'The studio does not answer. Your work stays in this page; save it when the simulator runs again.' : error.message;
}
