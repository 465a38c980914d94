/** Pointer controller for the pitch: turns and moves the view, selects robots, drags and throws the ball, drags and turns robots. */
import { headingTo, throwOf } from '../state/grip.js';
import { headingDegrees, standingHeight } from '../state/kinematics.js';
import { ballRadiusOf } from '../state/ball-radius.js';
import { Pointing } from './pointing.js';

/**
 * @typedef {import('./field-view.js').FieldView} FieldView
 * @typedef {import('./camera-controller.js').CameraController} CameraController
 * @typedef {import('./pointing.js').Thing} Thing
 *
 * @typedef {object} Grip state of a drag
 * @property {'turn' | 'move' | 'carry' | 'aim'} action aim = turns a robot, throws the ball
 * @property {Thing | undefined} thing
 * @property {number} gesture its number, which groups all commands of one drag into one undoable action
 * @property {number} x last pointer position
 * @property {number} y
 * @property {number} way length of the pointer's path in pixels
 * @property {number[]} [to] target on the ground
 * @property {boolean} [high] whether the ball flies high
 */

const TURN_DEGREES_PER_PIXEL = 0.35;
const CLICK_PIXELS = 5;
const ORDER_MILLISECONDS = 80;
const OVER_GROUND = 0.002;

/** Hints for dragging, by the target under the pointer. */
const TIPS = {
  ball: 'Drag the ball to move it; drag its ring to throw it',
  robot: 'Click to follow; drag to move the robot; drag its ring to turn it',
  'ball-ring': 'Pull to throw the ball; hold Shift for a high throw',
  'robot-ring': 'Drag around the robot to turn it',
};

export class PointerController {
  /** Number of the last drag. Starts at a random value, because other pages also number their drags. */
  #gestures = 1000 * Math.floor(1e9 * Math.random());
  #lastOrder = 0;
  /** @type {Grip | undefined} */
  #grip;

  /**
   * @param {FieldView} view
   * @param {CameraController} cameraController
   * @param {object} world
   * @param {() => import('./pointing.js').World} world.now
   * @param {() => boolean} world.isSteered whether objects can be moved
   * @param {(command: object) => void} world.send
   * @param {() => void} world.changed requests a redraw
   * @param {(tip: string) => void} [world.showTip] shows a hint on using the mouse
   */
  constructor(view, cameraController, world) {
    this.view = view;
    this.cameraController = cameraController;
    this.world = world;
    this.pointing = new Pointing(view, world.now, world.isSteered);
    const { stage } = view;
    stage.addEventListener('pointerdown', (event) => this.#press(event));
    stage.addEventListener('pointermove', (event) => this.#move(event));
    stage.addEventListener('pointerup', (event) => this.#release(event));
    stage.addEventListener('pointercancel', () => this.#letGo());
    stage.addEventListener('pointerleave', () => !this.#grip && this.#pointAt(undefined));
    stage.addEventListener('contextmenu', (event) => event.preventDefault());
    stage.addEventListener('wheel', (event) => this.#wheel(event), { passive: false });
  }

  /** Draws the ring around the object under the pointer, and moves it with the object. */
  draw() {
    const { marked } = this.pointing;
    const pose = marked && this.world.isSteered() ? this.pointing.poseOf(marked) : undefined;
    if (!marked || !pose) {
      this.view.ring.hide();
      return;
    }
    const to = this.#grip?.to;
    const busy = this.#grip?.action === 'aim' || (this.view.stage.dataset.over ?? '').endsWith('ring');
    const degrees = to ? headingTo(pose, to) : marked.kind === 'robot' ? headingDegrees(pose) : undefined;
    const length = to && marked.kind === 'ball' ? Math.hypot(to[0] - pose[0], to[1] - pose[1]) : undefined;
    this.view.ring.show(pose, this.pointing.radiusOf(marked), { degrees, length, busy });
  }

  /** @param {PointerEvent} event */
  #press(event) {
    const [aims, moves] = [event.ctrlKey || event.metaKey, event.button !== 0 || event.shiftKey];
    const found = event.button === 0 && (aims || !event.shiftKey) ? this.pointing.at(event) : undefined;
    const action = found ? (found.isRing || aims ? 'aim' : 'carry') : moves ? 'move' : 'turn';
    const { clientX: x, clientY: y } = event;
    this.#grip = { action, thing: found?.thing, gesture: ++this.#gestures, x, y, way: 0 };
    this.view.stage.setPointerCapture(event.pointerId);
    this.world.changed();
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const grip = this.#grip;
    if (!grip) {
      this.#pointAt(this.pointing.at(event));
      return;
    }
    const [dx, dy] = [event.clientX - grip.x, event.clientY - grip.y];
    Object.assign(grip, { x: event.clientX, y: event.clientY, way: grip.way + Math.hypot(dx, dy) });
    if (grip.action === 'turn') {
      this.cameraController.turn(-TURN_DEGREES_PER_PIXEL * dx, TURN_DEGREES_PER_PIXEL * dy);
    } else if (grip.action === 'move') {
      this.cameraController.move((-1.2 * dx) / this.view.stage.clientHeight, (1.2 * dy) / this.view.stage.clientHeight);
    } else if (grip.way > CLICK_PIXELS) {
      this.#drag(grip, event);
    }
    this.world.changed();
  }

  /** @param {{thing: Thing, isRing: boolean} | undefined} found */
  #pointAt(found) {
    const over = found ? `${found.thing.kind}${found.isRing ? '-ring' : ''}` : '';
    if (this.view.stage.dataset.over !== over) {
      this.view.stage.dataset.over = over;
      this.world.showTip?.(over && this.world.isSteered() ? TIPS[/** @type {keyof TIPS} */ (over)] : '');
      this.world.changed();
    }
  }

  /** @param {Grip} grip @param {PointerEvent} event */
  #drag(grip, event) {
    if (grip.action === 'aim') {
      grip.to = this.pointing.groundAt(event, 0)?.toArray();
      grip.high = event.shiftKey;
    }
    if (performance.now() - this.#lastOrder > ORDER_MILLISECONDS) {
      this.#act(grip, event);
    }
  }

  /** @param {PointerEvent} event */
  #release(event) {
    const grip = this.#grip;
    if (grip?.thing && grip.way > CLICK_PIXELS) {
      this.#act(grip, event);
      this.#throw(grip);
    } else if (grip?.action === 'carry' && grip.thing?.kind === 'robot') {
      this.cameraController.choose(grip.thing.robot);
    }
    this.#letGo();
  }

  #letGo() {
    this.#grip = undefined;
    this.#pointAt(undefined);
    this.world.changed();
  }

  /** @param {WheelEvent} event */
  #wheel(event) {
    event.preventDefault();
    this.cameraController.zoom(Math.exp(0.0012 * event.deltaY), this.pointing.groundAt(event, 0)?.toArray());
    this.world.changed();
  }

  /** @param {Grip} grip @param {PointerEvent} event */
  #act(grip, event) {
    this.#lastOrder = performance.now();
    if (grip.thing?.kind === 'robot') {
      this.#place(grip, grip.thing.robot, event);
    } else if (grip.action === 'carry') {
      const radius = ballRadiusOf(this.world.now().scene);
      const place = this.pointing.groundAt(event, radius);
      if (place) {
        this.world.send({ do: 'placeBall', gesture: grip.gesture, x: place.x, y: place.y, z: radius });
      }
    } else {
      this.#showSpeed(grip);
    }
  }

  /** Moves a robot, or turns it on the spot. @param {Grip} grip @param {number} robot @param {PointerEvent} event */
  #place({ action, to, gesture }, robot, event) {
    const { scene, frame } = this.world.now();
    const player = scene?.robots[robot];
    const state = frame?.robots[robot];
    if (!scene || !player?.side || !state) {
      return;
    }
    const { torso, degrees } = state;
    const height = standingHeight(scene.models[player.type], degrees);
    const place = action === 'aim' ? { x: torso[0], y: torso[1] } : this.pointing.groundAt(event, height);
    if (place) {
      this.world.send({
        do: 'placeRobot',
        gesture,
        side: player.side,
        number: player.number,
        x: place.x,
        y: place.y,
        z: height + OVER_GROUND,
        headingDegrees: (to && headingTo(torso, to)) ?? headingDegrees(torso),
        turn: action === 'aim',
      });
    }
  }

  /** @param {Grip} grip @returns {ReturnType<typeof throwOf>} */
  #throwOf({ thing, to, high }) {
    const ball = thing && this.pointing.poseOf(thing);
    return ball && to && thing.kind === 'ball' ? throwOf(ball, to, high === true) : undefined;
  }

  /** @param {Grip} grip */
  #showSpeed(grip) {
    const thrown = this.#throwOf(grip);
    this.world.showTip?.(thrown ? `Throw at ${thrown.speed.toFixed(1)} m/s${grip.high ? ', high' : ''}` : '');
  }

  /** @param {Grip} grip */
  #throw(grip) {
    const thrown = grip.action === 'aim' ? this.#throwOf(grip) : undefined;
    if (thrown) {
      const [x, y, z] = thrown.velocity;
      this.world.send({ do: 'throwBall', gesture: grip.gesture, x, y, z });
    }
  }
}
