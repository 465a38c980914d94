/** Camera controller: provides five camera modes and moves the view with mouse and keys. */
import { POSE, rotated } from '../state/kinematics.js';
import { eye, moved, openingShot, overview, turned, zoomed, zoomedTo } from '../state/view-point.js';

/**
 * @typedef {import('../state/view-point.js').ViewPoint} ViewPoint
 * @typedef {import('../state/view-point.js').FreeView} FreeView
 * @typedef {'orbit' | 'follow' | 'top' | 'eye' | 'ball'} CameraMode
 * @typedef {import('../live/state-frame.js').Scene} Scene
 */

/** The camera modes in the order of their keys 1 to 5. @type {Array<{mode: CameraMode, name: string, hint: string}>} */
export const CAMERAS = [
  { mode: 'orbit', name: 'Free', hint: 'Drag to turn the view; drag with the right button to move it' },
  { mode: 'follow', name: 'Follow', hint: 'Keeps the selected robot in the centre' },
  { mode: 'top', name: 'Top', hint: 'The whole pitch from above' },
  { mode: 'eye', name: 'Robot’s eyes', hint: 'The view through the selected robot’s eyes' },
  { mode: 'ball', name: 'Ball', hint: 'Follows the ball, as on television' },
];

const FIELD_OF_VIEW = 38;
const EYE_FIELD_OF_VIEW = 75;
const FOLLOW_HEIGHT = 0.29;
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
    /** The latest overview of the pitch, which is `view` until the user turns the camera. @type {ViewPoint | undefined} */
    this.whole = undefined;
    /** Whether the opening shot of a single robot is still to be composed. */
    this.isOpeningShot = false;
    /** @type {Scene | undefined} */
    this.scene = undefined;
  }

  /**
   * Chooses the view for the scene: follows a single robot, or shows several from the touchline.
   *
   * @param {Scene} scene
   */
  setScene(scene) {
    const first = this.scene === undefined;
    this.scene = scene;
    this.chosen = Math.min(this.chosen, Math.max(0, scene.robots.length - 1));
    const isLost = this.#needsRobot(this.mode) && scene.robots.length === 0;
    if (this.userHasChosen && !isLost) {
      return;
    }
    this.setMode(scene.robots.length === 1 ? 'follow' : 'orbit');
    this.isOpeningShot = this.mode === 'follow';
    this.userHasChosen = false;
    if (first) {
      this.shown = this.view;
    }
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
    this.isOpeningShot = false;
    this.mode = mode;
    if (mode === 'follow') {
      this.view = { ...this.view, azimuthDegrees: -38, elevationDegrees: 13, distance: 2.1 };
    } else if (mode === 'ball') {
      this.view = { ...this.view, azimuthDegrees: -90, elevationDegrees: 24, distance: 6.5 };
    } else if (mode !== 'eye') {
      this.#showAll();
    }
  }

  #showAll() {
    const field = this.scene?.field ?? { length: 12, width: 8 };
    this.whole = overview(field, this.free(), this.mode === 'top');
    this.view = this.whole;
  }

  /** Adapts the view after the area not covered by panels has changed. */
  refit() {
    if (this.view === this.whole) {
      this.#showAll();
    }
  }

  /** @param {ViewPoint} view applied immediately, without a transition */
  jumpTo(view) {
    this.view = view;
    this.shown = view;
    this.isStill = false;
  }

  /** Copies the view of another camera; an overview of the pitch is fitted to this camera's picture. @param {CameraController} other */
  lookAs({ mode, chosen, shown, view, whole }) {
    this.chosen = chosen;
    this.setMode(mode);
    if (view !== whole) {
      this.view = shown;
    }
    this.shown = this.view;
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
    this.isOpeningShot = false;
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
    this.isOpeningShot = false;
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
    const robot = poses[this.chosen];
    this.#setFieldOfView(this.mode === 'eye' && robot ? EYE_FIELD_OF_VIEW : FIELD_OF_VIEW);
    if (this.mode === 'eye' && robot) {
      return this.#lookThroughEyes(robot);
    }
    if (this.isOpeningShot && robot && robot[2] > 0 && ball) {
      this.#open(robot, ball);
    }
    if (this.mode === 'follow' && robot) {
      this.view = { ...this.view, target: [robot[0], robot[1], FOLLOW_HEIGHT] };
    }
    if (this.mode === 'ball' && ball) {
      this.view = { ...this.view, target: [ball[0], ball[1], 0.15] };
    }
    return this.#glide(Math.min(1, CATCH_UP_PER_SECOND * seconds));
  }

  /** @param {Float32Array} robot @param {number[]} ball */
  #open(robot, ball) {
    this.isOpeningShot = false;
    const scene = /** @type {Scene} */ (this.scene);
    const end = scene.robots[this.chosen].side === 'right' ? -1 : 1;
    const goal = [(end * scene.field.length) / 2, 0, 0];
    this.view = openingShot([robot[0], robot[1], FOLLOW_HEIGHT], ball, goal, this.free());
    this.shown = this.view;
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
    const model = /** @type {Scene} */ (this.scene).models[this.scene?.robots[this.chosen].type ?? ''];
    const head = model.links.findIndex(({ name }) => name === 'head');
    const at = head * POSE;
    const forward = rotated(robot, head, [0, 1, 0]);
    const place = [0, 1, 2].map((i) => robot[at + i] + 0.075 * forward[i]);
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
