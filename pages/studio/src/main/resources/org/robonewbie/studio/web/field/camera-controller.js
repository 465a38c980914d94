/** Camera controller: provides five camera modes and moves the view with the mouse and the keyboard. */
import { figureOf } from '../state/figure.js';
import { headingDegrees, POSE, rotated } from '../state/kinematics.js';
import { hasJumped } from '../state/smoothing.js';
import { eye, moved, overview, robotCentre, robotView, turned, zoomed, zoomedTo } from '../state/view-point.js';

/**
 * @typedef {import('../state/view-point.js').ViewPoint} ViewPoint
 * @typedef {import('../state/view-point.js').FreeView} FreeView
 * @typedef {'orbit' | 'follow' | 'top' | 'eye' | 'ball'} CameraMode
 * @typedef {import('../live/state-frame.js').Scene} Scene
 */

/** The camera modes in the order of their keys 1 to 5. @type {Array<{mode: CameraMode, name: string, hint: string}>} */
export const CAMERAS = [
  { mode: 'orbit', name: 'Free', hint: 'Drag to turn the view; drag with the right button to move it' },
  { mode: 'follow', name: 'Follow', hint: 'From the selected robot’s front right, with the robot in the centre' },
  { mode: 'top', name: 'Top', hint: 'The whole pitch from above' },
  { mode: 'eye', name: 'Robot’s eyes', hint: 'The view through the selected robot’s eyes' },
  { mode: 'ball', name: 'Ball', hint: 'Follows the ball, as on television' },
];

const FIELD_OF_VIEW = 38;
const EYE_FIELD_OF_VIEW = 75;
const CATCH_UP_PER_SECOND = 6;

export class CameraController {
  /**
   * @param {import('three').PerspectiveCamera} camera
   * @param {() => FreeView} free the area not covered by panels; by default the whole view
   */
  constructor(camera, free = () => wholeView(camera)) {
    this.camera = camera;
    this.free = free;
    /** @type {CameraMode} */
    this.mode = 'orbit';
    this.chosen = 0;
    this.userHasChosen = false;
    /** @type {ViewPoint} */
    this.view = { target: [0, 0, 0], azimuthDegrees: -90, elevationDegrees: 36, distance: 14 };
    /** @type {ViewPoint} */
    this.shown = this.view;
    /** Whether the camera has reached its target view. */
    this.isStill = false;
    /** Whether the view is still the one set by the mode: the user has not turned, zoomed or moved it. */
    this.isComposed = true;
    /** Whether the next picture shows the view without a transition. */
    this.isCut = true;
    /** Pose of the followed robot's torso in the last picture. @type {number[] | undefined} */
    this.followed = undefined;
    /** Heading of the followed robot when the view was composed. */
    this.headingDegrees = 0;
    /** @type {Scene | undefined} */
    this.scene = undefined;
  }

  /**
   * Chooses the view for the scene: follows a single robot, or shows several from the touchline.
   *
   * @param {Scene} scene
   */
  setScene(scene) {
    this.scene = scene;
    this.chosen = Math.min(this.chosen, Math.max(0, scene.robots.length - 1));
    const isLost = this.#needsRobot(this.mode) && scene.robots.length === 0;
    if (this.userHasChosen && !isLost) {
      return;
    }
    this.setMode(scene.robots.length === 1 ? 'follow' : 'orbit');
    this.isCut ||= this.mode === 'follow';
    this.userHasChosen = false;
  }

  get #followsSomething() {
    return this.#needsRobot(this.mode) || this.mode === 'ball';
  }

  /** @param {CameraMode} mode */
  #needsRobot(mode) {
    return mode === 'follow' || mode === 'eye';
  }

  /** Switches the camera mode; ignored if the mode needs a robot and there is none. @param {CameraMode} mode */
  setMode(mode) {
    if (this.#needsRobot(mode) && !this.scene?.robots.length) {
      return;
    }
    this.userHasChosen = true;
    this.isStill = false;
    this.mode = mode;
    this.isComposed = true;
    this.followed = undefined;
    if (mode === 'ball') {
      this.view = { ...this.view, azimuthDegrees: -90, elevationDegrees: 24, distance: 6.5 };
    }
    this.refit();
  }

  /** Adapts an overview of the pitch after the area not covered by panels has changed. */
  refit() {
    if (this.isComposed && !this.#followsSomething) {
      const field = this.scene?.field ?? { length: 12, width: 8 };
      this.view = overview(field, this.free(), this.mode === 'top');
    }
  }

  /** @param {ViewPoint} view applied immediately, without a transition */
  jumpTo(view) {
    this.view = view;
    this.isComposed = false;
    this.isCut = true;
    this.isStill = false;
  }

  /** Copies the view of another camera; a composed view is fitted to this camera's picture. @param {CameraController} other */
  lookAs({ mode, chosen, shown, isComposed, followed, headingDegrees: heading }) {
    this.chosen = chosen;
    this.setMode(mode);
    this.followed = followed;
    this.headingDegrees = heading;
    if (!isComposed) {
      this.jumpTo(shown);
    }
    this.isCut = true;
  }

  /** @param {number} robot index of the followed robot */
  choose(robot) {
    this.chosen = robot;
    if (this.mode !== 'eye') {
      this.setMode('follow');
    }
  }

  /** @param {number} right degrees @param {number} up degrees */
  turn(right, up) {
    this.#take();
    this.view = turned(this.view, right, up);
  }

  /** @param {number} factor zoom factor; below 1 zooms in @param {number[]} [point] point that stays fixed on the screen */
  zoom(factor, point) {
    this.isComposed = false;
    this.view = point && !this.#followsSomething ? zoomedTo(this.view, factor, point) : zoomed(this.view, factor);
  }

  /** @param {number} right fraction of the camera's distance @param {number} up fraction of the same distance */
  move(right, up) {
    this.#take();
    if (this.mode === 'follow' || this.mode === 'ball') {
      this.mode = 'orbit';
    }
    this.view = moved(this.view, right, up);
  }

  #take() {
    this.userHasChosen = true;
    this.isComposed = false;
    if (this.mode === 'top') {
      this.mode = 'orbit';
    }
  }

  /**
   * Advances the camera.
   *
   * @param {Float32Array[]} poses poses of all links of each robot
   * @param {number} seconds since the last call
   * @param {number[]} [ball] its position, if there is one
   * @returns {boolean} whether it has moved
   */
  update(poses, seconds, ball) {
    const robot = poses[this.chosen]?.[2] > 0 ? poses[this.chosen] : undefined;
    this.#setFieldOfView(this.mode === 'eye' && robot ? EYE_FIELD_OF_VIEW : FIELD_OF_VIEW);
    if (this.mode === 'eye' && robot) {
      return this.#lookThroughEyes(robot);
    }
    if (this.mode === 'follow' && robot) {
      this.#follow(robot);
    }
    if (this.mode === 'ball' && ball) {
      this.view = { ...this.view, target: [ball[0], ball[1], 0.15] };
    }
    const part = this.isCut ? 1 : Math.min(1, CATCH_UP_PER_SECOND * seconds);
    this.isCut &&= this.mode === 'follow' && !robot;
    return this.#glide(part);
  }

  /**
   * Keeps the robot in the centre. The camera does not turn with the robot; it returns to the robot's front only after the robot has been
   * repositioned.
   *
   * @param {Float32Array} robot
   */
  #follow(robot) {
    const torso = [...robot.subarray(0, POSE)];
    if (!this.followed || hasJumped(this.followed, torso)) {
      this.headingDegrees = headingDegrees(torso);
    }
    this.followed = torso;
    const { height } = figureOf(this.#model);
    const target = robotCentre(torso, height);
    const { view, headingDegrees: heading } = this;
    this.view = this.isComposed ? robotView(target, heading, this.free(), height) : { ...view, target };
  }

  /** The model of the chosen robot. */
  get #model() {
    const { models, robots } = /** @type {Scene} */ (this.scene);
    return models[robots[this.chosen].type];
  }

  /** The view of the followed robot, if the camera follows one. @type {ViewPoint | undefined} */
  get viewOfRobot() {
    return this.mode === 'follow' && this.followed ? this.shown : undefined;
  }

  /** @param {number} degrees */
  #setFieldOfView(degrees) {
    if (this.camera.fov !== degrees) {
      this.camera.fov = degrees;
      this.camera.updateProjectionMatrix();
    }
  }

  /** @param {Float32Array} robot */
  #lookThroughEyes(robot) {
    const { head, eye: camera } = figureOf(this.#model);
    const at = head * POSE;
    const forward = rotated(robot, head, [0, 1, 0]);
    const toEye = rotated(robot, head, camera);
    const place = [0, 1, 2].map((i) => robot[at + i] + toEye[i]);
    this.camera.up.set(...threeNumbers(rotated(robot, head, [0, 0, 1])));
    this.camera.position.set(...threeNumbers(place));
    this.camera.lookAt(place[0] + forward[0], place[1] + forward[1], place[2] + forward[2]);
    return true;
  }

  /** @param {number} part fraction of the remaining distance to cover */
  #glide(part) {
    const { view, shown } = this;
    const turn = shortestTurn(view.azimuthDegrees - shown.azimuthDegrees);
    const next = {
      target: shown.target.map((value, i) => value + part * (view.target[i] - value)),
      azimuthDegrees: shown.azimuthDegrees + part * turn,
      elevationDegrees: shown.elevationDegrees + part * (view.elevationDegrees - shown.elevationDegrees),
      distance: shown.distance + part * (view.distance - shown.distance),
    };
    const step =
      Math.hypot(...next.target.map((value, i) => value - shown.target[i])) +
      Math.abs(next.azimuthDegrees - shown.azimuthDegrees) / 50 +
      Math.abs(next.elevationDegrees - shown.elevationDegrees) / 50 +
      Math.abs(next.distance - shown.distance);
    this.shown = next;
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(...threeNumbers(eye(next)));
    this.camera.lookAt(...threeNumbers(next.target));
    this.isStill = step <= 0.0005;
    return !this.isStill;
  }
}

/** @param {import('three').PerspectiveCamera} camera @returns {FreeView} */
function wholeView(camera) {
  const up = Math.tan((FIELD_OF_VIEW / 2) * (Math.PI / 180));
  return { across: up * camera.aspect, up };
}

/**
 * @param {number[]} list
 * @returns {[number, number, number]}
 */
function threeNumbers(list) {
  return [list[0], list[1], list[2]];
}

/** @param {number} degrees */
function shortestTurn(degrees) {
  return ((((degrees + 180) % 360) + 360) % 360) - 180;
}
