/** All robots of the scene: one draw call for each kind of limb, however many robots play. */
import * as THREE from 'three';
import { computeLinkPoses, POSE } from '../state/kinematics.js';
import { numberMaterial, robotMaterial, TEAM_COLOURS } from './materials.js';
import { naoBodies, numberPlates } from './nao-design.js';

/**
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../live/state-frame.js').RobotState} RobotState
 *
 * @typedef {object} Limb
 * @property {THREE.InstancedMesh} mesh
 * @property {Array<{robot: number, link: number}>} places which link of which robot each instance is
 */

export class RobotCrowd {
  constructor() {
    this.group = new THREE.Group();
    this.numberMaterial = numberMaterial();
    /** @type {Limb[]} */
    this.limbs = [];
    /** @type {Float32Array[]} poses of all links of each robot */
    this.poses = [];
    /** @type {Scene | undefined} */
    this.scene = undefined;
    this.castsShadow = false;
    this.setQuality({ fine: true, glossy: true });
  }

  /** @param {{fine: boolean, glossy: boolean}} quality */
  setQuality(quality) {
    this.bodies = naoBodies(quality.fine);
    this.material = robotMaterial(quality.glossy);
    if (this.scene) {
      this.setScene(this.scene);
    }
  }

  /** @param {boolean} casts */
  setShadows(casts) {
    this.castsShadow = casts;
    this.limbs.forEach(({ mesh }) => {
      mesh.castShadow = casts;
    });
  }

  /** @param {Scene} scene */
  setScene(scene) {
    this.scene = scene;
    this.#clear();
    this.poses = scene.robots.map(({ type }) => new Float32Array(scene.models[type].links.length * POSE));
    for (const [name, body] of /** @type {Map<string, THREE.BufferGeometry>} */ (this.bodies)) {
      this.#addLimb(scene, body, this.#placesOf(scene, name));
    }
    this.#addNumbers(scene);
  }

  /** @param {RobotState[]} robots */
  update(robots) {
    const scene = /** @type {Scene} */ (this.scene);
    robots.forEach((robot, i) => {
      computeLinkPoses(scene.models[scene.robots[i].type], robot.torso, robot.degrees, this.poses[i]);
    });
    const matrix = new THREE.Matrix4();
    for (const { mesh, places } of this.limbs) {
      places.forEach(({ robot, link }, i) => mesh.setMatrixAt(i, poseMatrix(this.poses[robot], link, matrix)));
      mesh.instanceMatrix.needsUpdate = true;
    }
  }

  #clear() {
    this.limbs.forEach(({ mesh }) => {
      this.group.remove(mesh);
      mesh.dispose();
    });
    this.limbs = [];
  }

  /**
   * @param {Scene} scene
   * @param {string} name
   */
  #placesOf(scene, name) {
    return scene.robots.flatMap(({ type }, robot) => {
      const link = scene.models[type].links.findIndex((each) => each.name === name);
      return link < 0 ? [] : [{ robot, link }];
    });
  }

  /**
   * @param {Scene} scene
   * @param {THREE.BufferGeometry} body
   * @param {Array<{robot: number, link: number}>} places
   */
  #addLimb(scene, body, places) {
    if (places.length === 0) {
      return;
    }
    const colours = places.flatMap(({ robot }) => new THREE.Color(TEAM_COLOURS[scene.robots[robot].side]).toArray());
    const geometry = body.clone();
    geometry.setAttribute('teamColour', new THREE.InstancedBufferAttribute(new Float32Array(colours), 3));
    this.#add(geometry, /** @type {THREE.Material} */ (this.material), places).castShadow = this.castsShadow;
  }

  /** @param {Scene} scene */
  #addNumbers(scene) {
    const places = this.#placesOf(scene, 'body');
    const cells = new Float32Array(places.map(({ robot }) => scene.robots[robot].number));
    for (const geometry of places.length > 0 ? numberPlates() : []) {
      geometry.setAttribute('cell', new THREE.InstancedBufferAttribute(cells, 1));
      this.#add(geometry, this.numberMaterial, places);
    }
  }

  /**
   * @param {THREE.BufferGeometry} geometry
   * @param {THREE.Material} material
   * @param {Array<{robot: number, link: number}>} places
   */
  #add(geometry, material, places) {
    const mesh = new THREE.InstancedMesh(geometry, material, places.length);
    mesh.frustumCulled = false;
    mesh.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
    this.limbs.push({ mesh, places });
    this.group.add(mesh);
    return mesh;
  }
}

const position = new THREE.Vector3();
const rotation = new THREE.Quaternion();
const unit = new THREE.Vector3(1, 1, 1);

/**
 * @param {ArrayLike<number>} poses
 * @param {number} link
 * @param {THREE.Matrix4} matrix
 */
export function poseMatrix(poses, link, matrix) {
  const at = link * POSE;
  position.set(poses[at], poses[at + 1], poses[at + 2]);
  rotation.set(poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 3]);
  return matrix.compose(position, rotation, unit);
}
