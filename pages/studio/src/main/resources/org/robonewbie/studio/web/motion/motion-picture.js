/** Content of the 3D view in the motion room: the robot at the playhead, its ghosts, its balance and its faults. */
import { balanceOf } from '../state/motion/balance.js';
import { placed, posesOf } from '../state/motion/body.js';
import { framesOf, isOnKeyframe, postureNow } from '../state/motion/editor-state.js';
import { faultsAt, lagFaults } from '../state/motion/faults.js';
import { lagFrame } from '../state/motion/lag.js';
import { faultList } from './fault-list.js';

/**
 * @typedef {import('./editor.js').Editor} Editor
 * @typedef {import('./motion-stage.js').MotionStage} MotionStage
 * @typedef {import('./motion-stage.js').Figure} Figure
 */

export class MotionPicture {
  /** @param {MotionStage} stage @param {Editor} editor */
  constructor(stage, editor) {
    this.stage = stage;
    this.editor = editor;
    this.showFaults = faultList(stage.stage);
    /** The limb under the pointer. */
    this.over = -1;
    /** @type {number[] | undefined} pose of the torso while a limb is dragged */
    this.heldTorso = undefined;
  }

  /** Returns the displayed posture with the pose of its torso. */
  posedNow() {
    const { state } = this.editor;
    const posture = postureNow(state);
    return { posture, torso: this.heldTorso ?? placed(state.body, posture, state.manner) };
  }

  draw() {
    if (this.editor.state.trial && this.editor.state.watching) {
      this.#drawTrial();
    } else {
      this.#drawPlan();
    }
  }

  #drawPlan() {
    const { stage } = this;
    const { state, lag } = this.editor;
    stage.setBody(state.body);
    const { posture, torso } = this.posedNow();
    const poses = posesOf(state.body, posture, torso);
    const faults = faultsAt(state.body, framesOf(state), state.time, posture, poses);
    stage.show(stage.figure(posture, torso), this.#ghosts(torso));
    stage.marker.setBalance(state.body.isNao ? balanceOf(state.body, poses) : undefined);
    stage.marker.frameLink(state.body, state.playing ? -1 : this.over, poses);
    stage.paint.show(faults, poses);
    this.showFaults([...faults, ...(lag ? lagFaults(state.body, lag, state.time) : [])]);
  }

  /** Draws the physical robot, with the planned motion as a ghost. */
  #drawTrial() {
    const { stage } = this;
    const { state, lag } = this.editor;
    const robot = this.#robotOfTrial();
    if (!robot || !lag) {
      return;
    }
    const torso = Array.from(robot.torso);
    stage.cameraController.view = { ...stage.cameraController.view, target: [torso[0], torso[1], 0.31] };
    stage.show(robot, state.ghosts ? [this.#planAt(torso), undefined] : []);
    stage.marker.setBalance(undefined);
    stage.marker.frameLink(state.body, -1, new Float64Array());
    const faults = lagFaults(state.body, lag, state.time);
    stage.paint.show(faults, posesOf(state.body, lag.reached[lagFrame(lag, state.time)], torso));
    this.showFaults(faults);
  }

  /** @returns {Figure | undefined} */
  #robotOfTrial() {
    const { trial, time } = this.editor.state;
    const frame = trial?.frames[Math.min(trial.frames.length - 1, Math.round(time / 1000 / trial.frameSeconds))];
    return frame && { torso: frame.slice(0, 7), hinges: frame.slice(7) };
  }

  /** Returns the planned posture at this time, placed at the physical robot's torso. @param {readonly number[]} torso @returns {Figure} */
  #planAt(torso) {
    const { state, lag } = this.editor;
    const posture = lag ? lag.planned[lagFrame(lag, state.time)] : postureNow(state);
    const [, , z, ...rotation] = placed(state.body, posture, state.manner);
    return this.stage.figure(posture, [torso[0], torso[1], z, ...rotation]);
  }

  /**
   * Returns the ghosts: the physical robot if there is a trial, otherwise the previous and the next keyframe.
   *
   * @param {readonly number[]} torso
   * @returns {Array<Figure | undefined>}
   */
  #ghosts(torso) {
    const { state } = this.editor;
    const robot = this.#robotOfTrial();
    if (!state.ghosts || this.heldTorso) {
      return [];
    }
    if (robot) {
      const [, , ...height] = Array.from(robot.torso);
      return [undefined, { ...robot, torso: [torso[0], torso[1], ...height] }];
    }
    const next = isOnKeyframe(state) ? state.last + 1 : state.last;
    return state.playing ? [] : [state.last - 1, next].map((index) => this.#ghostOf(index));
  }

  /** @param {number} index index of a keyframe */
  #ghostOf(index) {
    const { state } = this.editor;
    const posture = framesOf(state)[index]?.degrees;
    return posture && this.stage.figure(posture, placed(state.body, posture, state.manner));
  }
}
