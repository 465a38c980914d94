/** The mouse on the pitch: turns and moves the view, chooses robots, drags ball and robots. */
import * as THREE from 'three';
import { headingDegrees, standingHeight } from '../state/kinematics.js';
import { BALL_RADIUS } from './ball.js';

/**
 * @typedef {import('./field-view.js').FieldView} FieldView
 * @typedef {import('./camera-desk.js').CameraDesk} CameraDesk
 * @typedef {import('../live/state-frame.js').Frame} Frame
 * @typedef {import('../live/state-frame.js').Scene} Scene
 *
 * @typedef {{kind: 'ball'} | {kind: 'robot', robot: number}} Thing
 *
 * @typedef {object} Grip what the pressed button does
 * @property {'turn' | 'move' | 'carry'} action
 * @property {Thing | undefined} thing
 * @property {number} x where the pointer was last
 * @property {number} y
 * @property {number} way how far it went, in pixels
 */

const TURN_DEGREES_PER_PIXEL = 0.35;
const CLICK_PIXELS = 5;
const CARRY_MILLISECONDS = 80;
const BALL_REACH = 2 * BALL_RADIUS;
const ROBOT_REACH = 0.2;

export class Hand {
  /**
   * @param {FieldView} view
   * @param {CameraDesk} desk
   * @param {object} world
   * @param {() => {scene: Scene | undefined, frame: Frame | undefined}} world.now
   * @param {(command: object) => void} world.send
   * @param {() => void} world.changed the picture must be drawn again
   */
  constructor(view, desk, world) {
    this.view = view;
    this.desk = desk;
    this.world = world;
    /** @type {Grip | undefined} */
    this.grip = undefined;
    this.lastCarry = 0;
    const { stage } = view;
    stage.addEventListener('pointerdown', (event) => this.#press(event));
    stage.addEventListener('pointermove', (event) => this.#drag(event));
    stage.addEventListener('pointerup', (event) => this.#release(event));
    stage.addEventListener('pointercancel', () => {
      this.grip = undefined;
    });
    stage.addEventListener('contextmenu', (event) => event.preventDefault());
    stage.addEventListener('wheel', (event) => this.#wheel(event), { passive: false });
  }

  /** @param {PointerEvent} event */
  #press(event) {
    const thing = event.button === 0 && !event.shiftKey ? this.#thingAt(event) : undefined;
    const moves = event.button !== 0 || event.shiftKey;
    const action = thing ? 'carry' : moves ? 'move' : 'turn';
    this.grip = { action, thing, x: event.clientX, y: event.clientY, way: 0 };
    this.view.stage.setPointerCapture(event.pointerId);
  }

  /** @param {PointerEvent} event */
  #drag(event) {
    const { grip } = this;
    if (!grip) {
      this.view.stage.dataset.over = this.#thingAt(event)?.kind ?? '';
      return;
    }
    const [dx, dy] = [event.clientX - grip.x, event.clientY - grip.y];
    Object.assign(grip, { x: event.clientX, y: event.clientY, way: grip.way + Math.hypot(dx, dy) });
    if (grip.action === 'turn') {
      this.desk.turn(-TURN_DEGREES_PER_PIXEL * dx, TURN_DEGREES_PER_PIXEL * dy);
    } else if (grip.action === 'move') {
      this.desk.move((-1.2 * dx) / this.view.stage.clientHeight, (1.2 * dy) / this.view.stage.clientHeight);
    } else if (grip.way > CLICK_PIXELS && performance.now() - this.lastCarry > CARRY_MILLISECONDS) {
      this.#carry(event);
    }
    this.world.changed();
  }

  /** @param {PointerEvent} event */
  #release(event) {
    const { grip } = this;
    this.grip = undefined;
    if (grip?.action !== 'carry') {
      return;
    }
    if (grip.way > CLICK_PIXELS) {
      this.grip = grip;
      this.#carry(event);
      this.grip = undefined;
    } else if (grip.thing?.kind === 'robot') {
      this.desk.choose(grip.thing.robot);
    }
    this.world.changed();
  }

  /** @param {WheelEvent} event */
  #wheel(event) {
    event.preventDefault();
    this.desk.zoom(Math.exp(0.0012 * event.deltaY), this.#groundAt(event, 0)?.toArray());
    this.world.changed();
  }

  /** @param {PointerEvent} event */
  #carry(event) {
    this.lastCarry = performance.now();
    const { scene, frame } = this.world.now();
    const thing = this.grip?.thing;
    if (!scene || !frame || !thing) {
      return;
    }
    if (thing.kind === 'ball') {
      const place = this.#groundAt(event, BALL_RADIUS);
      if (place) {
        this.world.send({ do: 'placeBall', x: place.x, y: place.y, z: BALL_RADIUS });
      }
      return;
    }
    const player = scene.robots[thing.robot];
    const { torso, degrees } = frame.robots[thing.robot];
    const height = standingHeight(scene.models[player.type], degrees);
    const place = this.#groundAt(event, height);
    if (place && player.side) {
      this.world.send({
        do: 'placeRobot',
        side: player.side,
        number: player.number,
        x: place.x,
        y: place.y,
        z: height + 0.002,
        headingDegrees: headingDegrees(torso),
      });
    }
  }

  /**
   * @param {PointerEvent} event
   * @returns {Thing | undefined}
   */
  #thingAt(event) {
    const { frame } = this.world.now();
    if (!frame) {
      return undefined;
    }
    const ray = this.view.rayAt(event.clientX, event.clientY);
    /** @type {Array<{thing: Thing, distance: number}>} */
    const hits = [];
    /** @param {Thing} thing @param {ArrayLike<number>} pose @param {number} reach */
    const test = (thing, pose, reach) => {
      const centre = new THREE.Vector3(pose[0], pose[1], pose[2]);
      const distance = centre.distanceTo(ray.origin);
      if (ray.distanceToPoint(centre) < Math.max(reach, 0.012 * distance)) {
        hits.push({ thing, distance });
      }
    };
    test({ kind: 'ball' }, frame.ball, BALL_REACH);
    frame.robots.forEach(({ torso }, robot) => test({ kind: 'robot', robot }, torso, ROBOT_REACH));
    hits.sort((a, b) => a.distance - b.distance);
    return hits[0]?.thing;
  }

  /**
   * @param {MouseEvent} event
   * @param {number} height of the plane in which the thing moves
   */
  #groundAt(event, height) {
    const plane = new THREE.Plane(new THREE.Vector3(0, 0, 1), -height);
    const place = this.view.rayAt(event.clientX, event.clientY).intersectPlane(plane, new THREE.Vector3());
    const field = this.world.now().scene?.field;
    if (!place || !field) {
      return undefined;
    }
    const bound = new THREE.Vector3(field.length / 2 + 1, field.width / 2 + 1, height);
    return place.clamp(bound.clone().multiplyScalar(-1), bound);
  }
}
