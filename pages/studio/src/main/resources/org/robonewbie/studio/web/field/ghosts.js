/** Draws the robots and the ball of a finished trial as transparent ghosts alongside those of the current one. */
import * as THREE from 'three';
import { BALL_RADIUS, ballRadiusOf } from '../state/ball-radius.js';
import { ghostMaterial } from './materials.js';
import { InstancedRobots } from './instanced-robots.js';

/**
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../live/state-frame.js').Frame} Frame
 */

/** Render order of the ghosts: transparent objects are drawn last. */
const AFTER_ROBOTS = 2;
const NO_NEAR_ROBOTS = { nearMetres: 0, maxNear: 0 };
const BALL_OPACITY = 0.4;

export class Ghosts {
  /** @type {Scene | undefined} */
  #scene;

  /** @param {THREE.Scene} place @param {import('../state/quality.js').Quality} quality */
  constructor(place, quality) {
    this.robots = new InstancedRobots(ghostMaterial);
    this.robots.setQuality({ ...quality, ...NO_NEAR_ROBOTS });
    this.ball = new THREE.Mesh(
      new THREE.SphereGeometry(BALL_RADIUS, 16, 12),
      new THREE.MeshLambertMaterial({ transparent: true, opacity: BALL_OPACITY, depthWrite: false }),
    );
    this.ball.renderOrder = AFTER_ROBOTS;
    this.group = new THREE.Group();
    this.group.add(this.robots.group, this.ball);
    this.group.visible = false;
    place.add(this.group);
  }

  /** @param {{scene: Scene, frame: Frame} | undefined} moment @param {THREE.Vector3} eye camera position */
  show(moment, eye) {
    this.group.visible = moment !== undefined;
    if (moment) {
      this.#setScene(moment.scene);
      this.robots.update(moment.frame.robots, eye);
      const [x, y, z] = moment.frame.ball;
      this.ball.position.set(x, y, z);
      this.ball.scale.setScalar(ballRadiusOf(moment.scene) / BALL_RADIUS);
    }
  }

  /** Ghosts have no number plates, which would be opaque. @param {Scene} scene */
  #setScene(scene) {
    if (scene !== this.#scene) {
      this.#scene = scene;
      this.robots.setScene({ ...scene, robots: scene.robots.map((player) => ({ ...player, number: 0 })) });
      this.robots.meshes.forEach((mesh) => {
        mesh.renderOrder = AFTER_ROBOTS;
      });
    }
  }
}
