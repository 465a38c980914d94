/** Picking: finds the ball, a robot, the ring around one of them, or the ground under the pointer. */
import * as THREE from 'three';
import { isOnRing, ringRadius } from '../state/grip.js';
import { ballRadiusOf } from '../state/ball-radius.js';
import { figureOf } from '../state/figure.js';

/**
 * @typedef {import('../live/state-frame.js').Frame} Frame
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {{scene: Scene | undefined, frame: Frame | undefined}} World
 *
 * @typedef {{kind: 'ball'} | {kind: 'robot', robot: number}} Thing
 */

/** Distance from the torso at which a robot is picked, as a fraction of its height. */
const ROBOT_REACH = 0.35;
const MIN_REACH_PER_METRE = 0.012;
const BORDER_METRES = 1;

/** Distance at which the pointer leaves an object, as a multiple of the ring's radius. */
const LEAVE = 1.7;

export class Pointing {
  /** The object under the pointer, or the last one chosen; the ring is drawn around it. @type {Thing | undefined} */
  marked;

  /**
   * @param {import('./field-view.js').FieldView} view
   * @param {() => World} now
   * @param {() => boolean} hasRings whether objects can be turned and thrown
   */
  constructor(view, now, hasRings) {
    this.view = view;
    this.now = now;
    this.hasRings = hasRings;
  }

  /** @param {Thing} thing @returns {Float32Array | undefined} its pose, if it exists */
  poseOf(thing) {
    const { frame } = this.now();
    return thing.kind === 'ball' ? frame?.ball : frame?.robots[thing.robot]?.torso;
  }

  /** @param {Thing} thing @returns {number} radius of its ring, metres */
  radiusOf(thing) {
    const [x = 0, y = 0, z = 0] = this.poseOf(thing) ?? [];
    return ringRadius(thing.kind, this.view.metresPerPixel(new THREE.Vector3(x, y, z)));
  }

  /**
   * Picks the object under the pointer and marks it.
   *
   * @param {MouseEvent} event
   * @returns {{thing: Thing, isRing: boolean} | undefined}
   */
  at(event) {
    const thing = this.#thingAt(event);
    const marked = this.hasRings() ? this.marked : undefined;
    const onGround = marked && this.groundAt(event, 0)?.toArray();
    const centre = marked && this.poseOf(marked);
    if (marked && centre && onGround && !thing) {
      const radius = this.radiusOf(marked);
      if (isOnRing(centre, onGround, radius)) {
        return { thing: marked, isRing: true };
      }
      const isLeft = Math.hypot(onGround[0] - centre[0], onGround[1] - centre[1]) > LEAVE * radius;
      this.marked = isLeft ? undefined : marked;
      return undefined;
    }
    this.marked = thing;
    return thing && { thing, isRing: false };
  }

  /**
   * @param {MouseEvent} event
   * @returns {Thing | undefined} the nearest object under the pointer
   */
  #thingAt(event) {
    const { frame } = this.now();
    if (!frame) {
      return undefined;
    }
    const ray = this.view.rayAt(event.clientX, event.clientY);
    /** @type {Thing[]} */
    const things = [
      { kind: 'ball' },
      ...frame.robots.map((_, robot) => /** @type {const} */ ({ kind: 'robot', robot })),
    ];
    const hits = things.flatMap((thing) => {
      const [x, y, z] = /** @type {Float32Array} */ (this.poseOf(thing));
      const centre = new THREE.Vector3(x, y, z);
      const distance = centre.distanceTo(ray.origin);
      const reach = Math.max(this.#reachOf(thing), MIN_REACH_PER_METRE * distance);
      return ray.distanceToPoint(centre) < reach ? [{ thing, distance }] : [];
    });
    return hits.sort((a, b) => a.distance - b.distance)[0]?.thing;
  }

  /** @param {Thing} thing @returns {number} metres */
  #reachOf(thing) {
    const { scene } = this.now();
    const model = thing.kind === 'robot' ? scene?.models[scene.robots[thing.robot].type] : undefined;
    return model ? ROBOT_REACH * figureOf(model).height : 2 * ballRadiusOf(scene);
  }

  /**
   * @param {MouseEvent} event
   * @param {number} height height of a plane above the ground, metres
   * @returns {THREE.Vector3 | undefined} the point on it, at most one metre beyond the pitch
   */
  groundAt(event, height) {
    const plane = new THREE.Plane(new THREE.Vector3(0, 0, 1), -height);
    const place = this.view.rayAt(event.clientX, event.clientY).intersectPlane(plane, new THREE.Vector3());
    const field = this.now().scene?.field;
    if (!place || !field) {
      return undefined;
    }
    const bound = new THREE.Vector3(field.length / 2 + BORDER_METRES, field.width / 2 + BORDER_METRES, height);
    return place.clamp(bound.clone().multiplyScalar(-1), bound);
  }
}
