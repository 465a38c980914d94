/** All robots of the scene: one draw call for each kind of limb, however many robots play. */
import * as THREE from 'three';
import { computeLinkPoses, POSE } from '../state/kinematics.js';
import { limbFit } from '../state/limb-fit.js';
import { numberMaterial, robotMaterial, TEAM_COLOURS } from './materials.js';
import { naoBodies, numberPlates } from './nao-design.js';

/**
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../live/state-frame.js').RobotState} RobotState
 * @typedef {import('./nao-design.js').Detail} Detail
 * @typedef {import('../state/quality.js').Quality} Quality
 *
 * @typedef {object} Limb
 * @property {THREE.InstancedMesh} mesh
 * @property {Place[]} places which link of which robot it can show
 * @property {Distance} distance which robots it shows
 *
 * @typedef {'near' | 'far' | 'any'} Distance
 *
 * @typedef {object} Place
 * @property {number} robot index of the robot
 * @property {number} link index of its link
 * @property {THREE.Matrix4} fit how the design is stretched for its type
 */

export class RobotCrowd {
  constructor() {
    this.group = new THREE.Group();
    this.numberMaterial = numberMaterial();
    /** @type {Limb[]} */
    this.limbs = [];
    /** @type {Float32Array[]} poses of all links of each robot */
    this.poses = [];
    /** @type {boolean[]} whether each robot is near enough to be drawn finely */
    this.near = [];
    /** @type {Scene | undefined} */
    this.scene = undefined;
    this.castsShadow = false;
    this.nearMetres = 0;
    this.mostNear = 0;
  }

  /** @param {Quality} quality */
  setQuality(quality) {
    this.bodies = { near: naoBodies(quality.nearDetail), far: naoBodies(quality.farDetail) };
    this.material = robotMaterial(quality.glossy);
    this.nearMetres = quality.nearMetres;
    this.mostNear = quality.mostNear;
    if (this.scene) {
      this.setScene(this.scene);
    }
  }

  /** @param {boolean} casts */
  setShadows(casts) {
    this.castsShadow = casts;
    this.limbs.forEach(({ mesh, distance }) => {
      mesh.castShadow = casts && distance !== 'any';
    });
  }

  /** @param {Scene} scene */
  setScene(scene) {
    this.scene = scene;
    this.#clear();
    this.poses = scene.robots.map(({ type }) => new Float32Array(scene.models[type].links.length * POSE));
    for (const distance of /** @type {const} */ (['near', 'far'])) {
      for (const [name, body] of this.bodies?.[distance] ?? []) {
        this.#addLimb(body.clone(), distance, this.#placesOf(scene, name));
      }
    }
    for (const plate of numberPlates()) {
      this.#addLimb(plate, 'any', this.#placesOf(scene, 'body'));
    }
  }

  /**
   * Moves all limbs.
   *
   * @param {RobotState[]} robots
   * @param {THREE.Vector3} eye where the camera is
   */
  update(robots, eye) {
    const scene = /** @type {Scene} */ (this.scene);
    robots.forEach((robot, i) => {
      computeLinkPoses(scene.models[scene.robots[i].type], robot.torso, robot.degrees, this.poses[i]);
    });
    const sorted = this.#judgeDistances(eye);
    this.limbs.forEach((limb) => this.#moveLimb(limb, scene, sorted));
  }

  /**
   * Finds out who is near.
   *
   * @param {THREE.Vector3} eye
   * @returns {boolean} whether that has changed
   */
  #judgeDistances(eye) {
    const distances = this.poses.map(([x, y, z]) => Math.hypot(x - eye.x, y - eye.y, z - eye.z));
    const limit = Math.min(this.nearMetres, [...distances].sort((a, b) => a - b)[this.mostNear] ?? Infinity);
    const near = distances.map((distance) => distance < limit);
    const changed = near.length !== this.near.length || near.some((value, i) => value !== this.near[i]);
    this.near = near;
    return changed;
  }

  /**
   * @param {Limb} limb
   * @param {Scene} scene
   * @param {boolean} sorted whether other robots may be near than before
   */
  #moveLimb({ mesh, places, distance }, scene, sorted) {
    let count = 0;
    for (const { robot, link, fit } of places) {
      if (distance === 'any' || (distance === 'near') === this.near[robot]) {
        mesh.setMatrixAt(count, poseMatrix(this.poses[robot], link, matrix).multiply(fit));
        if (sorted) {
          paintInstance(mesh.geometry, count, scene.robots[robot]);
        }
        count++;
      }
    }
    mesh.count = count;
    mesh.visible = count > 0;
    mesh.instanceMatrix.needsUpdate = true;
  }

  #clear() {
    this.near = [];
    this.limbs.forEach(({ mesh }) => {
      this.group.remove(mesh);
      mesh.geometry.dispose();
      mesh.dispose();
    });
    this.limbs = [];
  }

  /**
   * @param {Scene} scene
   * @param {string} name
   * @returns {Place[]}
   */
  #placesOf(scene, name) {
    return scene.robots.flatMap(({ type }, robot) => {
      const link = scene.models[type].links.findIndex((each) => each.name === name);
      return link < 0 ? [] : [{ robot, link, fit: fitMatrix(scene.models[type], link) }];
    });
  }

  /**
   * @param {THREE.BufferGeometry} geometry
   * @param {Distance} distance
   * @param {Place[]} places
   */
  #addLimb(geometry, distance, places) {
    if (places.length === 0 || geometry.getAttribute('position').count === 0) {
      return;
    }
    geometry.setAttribute('teamColour', new THREE.InstancedBufferAttribute(new Float32Array(3 * places.length), 3));
    geometry.setAttribute('cell', new THREE.InstancedBufferAttribute(new Float32Array(places.length), 1));
    const material = distance === 'any' ? this.numberMaterial : this.material;
    const mesh = new THREE.InstancedMesh(geometry, material, places.length);
    mesh.frustumCulled = false;
    mesh.castShadow = this.castsShadow && distance !== 'any';
    mesh.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
    this.limbs.push({ mesh, places, distance });
    this.group.add(mesh);
  }
}

/**
 * @param {import('../state/kinematics.js').RobotModel} model
 * @param {number} link
 */
function fitMatrix(model, link) {
  const { scale, offset } = limbFit(model, link);
  return new THREE.Matrix4().makeScale(scale[0], scale[1], scale[2]).setPosition(offset[0], offset[1], offset[2]);
}

/**
 * Gives an instance the team's colour and the number of a robot.
 *
 * @param {THREE.BufferGeometry} geometry
 * @param {number} index
 * @param {import('../live/state-frame.js').Player} player
 */
function paintInstance(geometry, index, player) {
  const team = geometry.getAttribute('teamColour');
  colour.set(TEAM_COLOURS[player.side]);
  team.setXYZ(index, colour.r, colour.g, colour.b);
  team.needsUpdate = true;
  const cell = geometry.getAttribute('cell');
  cell.setX(index, player.number);
  cell.needsUpdate = true;
}

const colour = new THREE.Color();
const matrix = new THREE.Matrix4();
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
