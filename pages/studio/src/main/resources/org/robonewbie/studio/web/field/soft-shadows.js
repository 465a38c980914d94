/** Soft round spots under the feet, the bodies and the ball: a cheap approximation of shadows. */
import * as THREE from 'three';
import { POSE } from '../state/kinematics.js';
import { BALL_RADIUS, ballRadiusOf } from '../state/ball-radius.js';
import { figureOf } from '../state/figure.js';

/** @typedef {import('../live/state-frame.js').Scene} Scene */

const OVER_LINES = 0.004;

/** Shadow casters: half width and half length of a spot in metres, its darkness on the ground, and up to which height it is seen. */
const BODY = { wide: 0.2, long: 0.2, dark: 0.42, reach: 0.8 };
const FOOT = { wide: 0.085, long: 0.125, dark: 0.6, reach: 0.12 };

/** Height of the NAO, for which the spots are made. */
const NAO_METRES = 0.58;

export class SoftShadows {
  constructor() {
    this.material = new THREE.ShaderMaterial({
      transparent: true,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -4,
      polygonOffsetUnits: -4,
      vertexShader: `
        attribute float darkness;
        varying vec2 place;
        varying float strength;
        void main() {
          place = position.xy;
          strength = darkness;
          gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position, 1.0);
        }`,
      fragmentShader: `
        varying vec2 place;
        varying float strength;
        void main() {
          float fade = max(0.0, 1.0 - dot(place, place));
          gl_FragColor = vec4(0.0, 0.02, 0.01, strength * fade * fade);
        }`,
    });
    this.group = new THREE.Group();
    this.radius = BALL_RADIUS;
    /** @type {Array<{robot: number, link: number, caster: typeof BODY}>} */
    this.places = [];
  }

  /** @param {Scene} scene */
  setScene(scene) {
    this.radius = ballRadiusOf(scene);
    this.places = scene.robots.flatMap(({ type }, robot) => {
      const { height, feet } = figureOf(scene.models[type]);
      const caster = (/** @type {typeof BODY} */ spot) => scaled(spot, height / NAO_METRES);
      return [{ robot, link: 0, caster: caster(BODY) }, ...feet.map((link) => ({ robot, link, caster: caster(FOOT) }))];
    });
    const geometry = new THREE.CircleGeometry(1, 20);
    this.darkness = new THREE.InstancedBufferAttribute(new Float32Array(this.places.length + 1), 1);
    geometry.setAttribute('darkness', this.darkness);
    this.group.clear();
    this.mesh?.dispose();
    this.mesh = new THREE.InstancedMesh(geometry, this.material, this.places.length + 1);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 1;
    this.group.add(this.mesh);
  }

  /**
   * @param {Float32Array[]} poses poses of all links of each robot
   * @param {Float32Array} ball pose
   */
  update(poses, ball) {
    this.places.forEach(({ robot, link, caster }, i) => {
      const at = link * POSE;
      const height = Math.max(0, poses[robot][at + 2] - 0.015);
      this.#put(i, poses[robot], at, caster.wide, caster.long, caster.dark * Math.max(0, 1 - height / caster.reach));
    });
    const height = Math.max(0, ball[2] - this.radius);
    const wide = 1.25 * this.radius + 0.3 * height;
    this.#put(this.places.length, ball, 0, wide, wide, 0.75 / (1 + 12 * height), true);
    if (this.mesh && this.darkness) {
      this.mesh.instanceMatrix.needsUpdate = true;
      this.darkness.needsUpdate = true;
    }
  }

  /**
   * @param {number} index
   * @param {Float32Array} poses
   * @param {number} at
   * @param {number} wide
   * @param {number} long
   * @param {number} dark
   * @param {boolean} [round] whether the spot is a circle
   */
  #put(index, poses, at, wide, long, dark, round = false) {
    const [w, x, y, z] = poses.slice(at + 3, at + POSE);
    const turn = round ? 0 : Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
    rotation.setFromAxisAngle(up, turn);
    position.set(poses[at], poses[at + 1], OVER_LINES);
    scale.set(wide, long, 1);
    this.mesh?.setMatrixAt(index, matrix.compose(position, rotation, scale));
    this.darkness?.setX(index, dark);
  }
}

/** @param {typeof BODY} spot @param {number} factor */
function scaled({ wide, long, dark, reach }, factor) {
  return { wide: wide * factor, long: long * factor, dark, reach: reach * factor };
}

const up = new THREE.Vector3(0, 0, 1);
const position = new THREE.Vector3();
const rotation = new THREE.Quaternion();
const scale = new THREE.Vector3();
const matrix = new THREE.Matrix4();
