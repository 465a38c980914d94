/** Pointer controller for the motion editor's 3D view: drags limbs, and turns and moves the camera. */
import * as THREE from 'three';
import { poseMatrix } from '../field/robot-batch.js';
import { rotated } from '../state/kinematics.js';
import { pointOf, posesOf } from '../state/motion/body.js';
import { farFrom, limitSign, stuckJoint } from './limit-sign.js';
import { chainJoints, limbOf, ownJoints, followed, torsoMoved } from '../state/motion/reach.js';

/**
 * @typedef {import('./motion-stage.js').MotionStage} MotionStage
 *
 * @typedef {object} Grip
 * @property {'turn' | 'move' | 'dragLimb'} action
 * @property {number} x
 * @property {number} y
 * @property {number} link
 * @property {number[]} local the grabbed point in the limb's frame
 * @property {THREE.Plane} plane plane in which the point is dragged
 * @property {number[]} from last position of the point
 * @property {number[]} posture posture at the start of the drag
 * @property {number[]} reached posture reached so far
 * @property {number[]} torso pose of the torso at the start of the drag
 * @property {string} gesture
 */

const TURN_DEGREES_PER_PIXEL = 0.35;
const DRAG_MILLISECONDS = 24;

export class LimbController {
  /**
   * @param {MotionStage} stage
   * @param {object} editor
   * @param {() => {posture: readonly number[], torso: number[]} | undefined} editor.now the draggable figure, if any
   * @param {(posture: number[], from: Grip, torso: number[]) => void} editor.pose
   * @param {() => void} editor.released
   * @param {(link: number) => void} editor.over
   * @param {() => void} editor.changed requests a redraw
   */
  constructor(stage, editor) {
    this.view = stage;
    this.editor = editor;
    /** @type {Grip | undefined} */
    this.grip = undefined;
    this.gestures = 0;
    this.lastDrag = 0;
    this.sign = limitSign(stage.stage, () => stage.body);
    const target = stage.stage;
    target.addEventListener('pointerdown', (event) => this.#press(event));
    target.addEventListener('pointermove', (event) => this.#drag(event));
    target.addEventListener('pointerup', (event) => this.#release(event));
    target.addEventListener('pointercancel', () => this.#drop());
    target.addEventListener('pointerleave', () => this.grip ?? this.editor.over(-1));
    target.addEventListener('contextmenu', (event) => event.preventDefault());
    target.addEventListener('wheel', (event) => this.#wheel(event), { passive: false });
  }

  /** @param {PointerEvent} event */
  #press(event) {
    if (!(event.target instanceof HTMLCanvasElement)) {
      return;
    }
    const now = this.editor.now();
    const hit = event.button === 0 && now ? this.#limbAt(event, now) : undefined;
    const moves = event.button !== 0 || (event.shiftKey && !hit);
    this.view.stage.setPointerCapture(event.pointerId);
    this.grip = {
      action: hit ? 'dragLimb' : moves ? 'move' : 'turn',
      x: event.clientX,
      y: event.clientY,
      link: hit?.link ?? -1,
      local: hit?.local ?? [0, 0, 0],
      from: hit?.point ?? [0, 0, 0],
      plane: this.#planeThrough(hit?.point),
      ...startOf(now),
      gesture: `drag ${++this.gestures}`,
    };
  }

  /** Returns the plane in which a limb is dragged. @param {number[]} [point] */
  #planeThrough(point) {
    const plane = new THREE.Plane();
    if (point) {
      const forward = this.view.camera.getWorldDirection(new THREE.Vector3());
      plane.setFromNormalAndCoplanarPoint(forward, vector(point));
    }
    return plane;
  }

  /** @param {PointerEvent} event */
  #drag(event) {
    const { grip } = this;
    if (!grip) {
      const now = this.editor.now();
      this.editor.over(now ? (this.#limbAt(event, now)?.link ?? -1) : -1);
      return;
    }
    const [dx, dy] = [event.clientX - grip.x, event.clientY - grip.y];
    if (grip.action === 'dragLimb') {
      if (performance.now() - this.lastDrag > DRAG_MILLISECONDS) {
        this.#dragLimb(event, grip);
      }
      return;
    }
    Object.assign(grip, { x: event.clientX, y: event.clientY });
    if (grip.action === 'turn') {
      this.view.cameraController.turn(-TURN_DEGREES_PER_PIXEL * dx, TURN_DEGREES_PER_PIXEL * dy);
    } else {
      const { target } = this.view.cameraController.view;
      this.view.cameraController.move((-1.2 * dx) / this.view.stage.clientHeight, 0);
      this.view.cameraController.view.target[2] = Math.max(
        0,
        Math.min(1, target[2] + (0.9 * dy) / this.view.stage.clientHeight),
      );
    }
    this.editor.changed();
  }

  /** @param {PointerEvent} event */
  #release(event) {
    const { grip } = this;
    const went = grip && Math.hypot(event.clientX - grip.x, event.clientY - grip.y) > 2;
    if (grip?.action === 'dragLimb' && went) {
      this.#dragLimb(event, grip);
    }
    this.#drop();
  }

  #drop() {
    this.grip = undefined;
    this.sign(undefined);
    this.editor.released();
  }

  /** @param {WheelEvent} event */
  #wheel(event) {
    event.preventDefault();
    this.view.cameraController.zoom(Math.exp(0.0012 * event.deltaY));
    this.editor.changed();
  }

  /** @param {PointerEvent} event @param {Grip} grip */
  #dragLimb(event, grip) {
    this.lastDrag = performance.now();
    const place = this.view.rayAt(event.clientX, event.clientY).intersectPlane(grip.plane, new THREE.Vector3());
    if (!place) {
      return;
    }
    const target = place.toArray();
    const { body } = this.view;
    if (grip.link === 0 && !body.isNao) {
      return;
    }
    if (grip.link === 0) {
      const way = target.map((value, axis) => value - grip.from[axis]);
      const moved = torsoMoved(body, grip.posture, grip.torso, way);
      this.editor.pose(tenths(moved.posture, grip.posture), grip, moved.torso);
      return;
    }
    const { link, local } = grip;
    const whole = event.shiftKey;
    const joints = whole ? chainJoints(body, link) : ownJoints(body, link);
    const isFoot = body.model.links[link].name.endsWith('foot');
    const up = whole && isFoot ? rotated(posesOf(body, grip.posture, grip.torso), link, [0, 0, 1]) : undefined;
    const posture = followed(body, grip.reached, grip.torso, { link, local, target, up, joints });
    grip.reached = posture;
    this.sign(
      stuckJoint(body, posture, joints, farFrom(target, pointOf(posesOf(body, posture, grip.torso), link, local))),
    );
    this.editor.pose(tenths(posture, grip.posture), grip, grip.torso);
  }

  /**
   * @param {PointerEvent} event
   * @param {{posture: readonly number[], torso: number[]}} now
   */
  #limbAt(event, { posture, torso }) {
    const { body } = this.view;
    const ray = this.view.rayAt(event.clientX, event.clientY);
    const poses = posesOf(body, posture, torso);
    /** @type {{link: number, point: number[], local: number[], distance: number} | undefined} */
    let best;
    body.model.links.forEach((each, i) => {
      const inverse = poseMatrix(poses, i, new THREE.Matrix4()).invert();
      const local = ray.clone().applyMatrix4(inverse);
      const half = new THREE.Vector3(...each.size.map((edge) => Math.max(0.035, edge * 0.58)));
      const point = local.intersectBox(new THREE.Box3(half.clone().negate(), half), new THREE.Vector3());
      if (!point) {
        return;
      }
      const world = pointOf(poses, i, point.toArray());
      const distance = vector(world).distanceTo(ray.origin);
      if (!best || distance < best.distance) {
        best = { link: i, point: world, local: point.toArray(), distance };
      }
    });
    return best && this.#asLimb(best, poses);
  }

  /**
   * @param {{link: number, point: number[]}} hit
   * @param {Float64Array} poses
   */
  #asLimb({ link, point }, poses) {
    const limb = limbOf(this.view.body, link);
    const local = vector(point).applyMatrix4(poseMatrix(poses, limb, new THREE.Matrix4()).invert());
    return { link: limb, point, local: local.toArray() };
  }
}

/** @param {{posture: readonly number[], torso: number[]} | undefined} now */
function startOf(now) {
  const { posture = [], torso = [] } = now ?? {};
  return { posture: [...posture], reached: [...posture], torso: [...torso] };
}

/**
 * Rounds the angles changed by the drag to a tenth of a degree; all other angles remain unchanged.
 *
 * @param {readonly number[]} posture
 * @param {readonly number[]} before
 */
function tenths(posture, before) {
  return posture.map((angle, i) => (angle === before[i] ? angle : Math.round(angle * 10) / 10 + 0));
}

/** @param {number[]} list */
function vector(list) {
  return new THREE.Vector3(list[0], list[1], list[2]);
}
