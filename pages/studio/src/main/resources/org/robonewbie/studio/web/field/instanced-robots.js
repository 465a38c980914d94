/** Draws all robots in the scene in three draw calls, regardless of their number. */
import * as THREE from 'three';
import { computeLinkPoses, POSE } from '../state/kinematics.js';
import { limbFit } from '../state/limb-fit.js';
import { numberMaterial, robotMaterial, TEAM_COLOURS } from './materials.js';
import { LIMBS, naoBody, numberPlates } from './nao-design.js';
import { RobotTable } from './robot-table.js';

/**
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../live/state-frame.js').RobotState} RobotState
 * @typedef {import('../state/quality.js').Quality} Quality
 *
 * @typedef {object} Place source and destination of a limb's pose
 * @property {number} robot index of the robot
 * @property {number} limb index of the kind of limb
 * @property {number} link index of the robot's link
 * @property {THREE.Matrix4} fit transformation that fits the design to the robot type
 */

/** Render order of the robots: before the ground, much of which they hide. */
const BEFORE_GROUND = -1;

export class InstancedRobots {
  /** @param {THREE.Material} [material] material for all bodies; by default it depends on the quality */
  constructor(material) {
    this.group = new THREE.Group();
    this.table = new RobotTable();
    this.fixedMaterial = material && this.table.posed(material);
    this.numberMaterial = this.table.posed(numberMaterial());
    this.depthMaterial = this.table.posed(new THREE.MeshDepthMaterial({ depthPacking: THREE.RGBADepthPacking }));
    /** @type {Array<{body: THREE.BufferGeometry, material: THREE.Material}>} near robots, far robots, and all number plates */
    this.looks = [];
    /** @type {THREE.Mesh[]} one per look */
    this.meshes = [];
    /** @type {Place[]} */
    this.places = [];
    /** @type {Float32Array[]} poses of all links of each robot */
    this.poses = [];
    /** @type {boolean[]} whether each robot is near enough for the fine geometry */
    this.near = [];
    /** @type {Scene | undefined} */
    this.scene = undefined;
    this.castsShadow = false;
    this.nearMetres = 0;
    this.maxNear = 0;
  }

  /** @param {Quality} quality */
  setQuality(quality) {
    this.nearMetres = quality.nearMetres;
    this.maxNear = quality.maxNear;
    const material = this.fixedMaterial ?? this.table.posed(robotMaterial(quality.glossy));
    this.looks = [
      { body: naoBody(quality.nearDetail), material },
      { body: naoBody(quality.farDetail), material },
      { body: numberPlates(), material: this.numberMaterial },
    ];
    if (this.scene) {
      this.setScene(this.scene);
    }
  }

  /** @param {boolean} casts */
  setShadows(casts) {
    this.castsShadow = casts;
    this.meshes.forEach((mesh, index) => {
      mesh.castShadow = casts && index < 2;
    });
  }

  /** @param {Scene} scene */
  setScene(scene) {
    this.scene = scene;
    this.near = [];
    this.poses = scene.robots.map(({ type }) => new Float32Array(scene.models[type].links.length * POSE));
    this.places = scene.robots.flatMap(({ type }, robot) => placesOf(scene.models[type], robot));
    this.table.clear(scene.robots.length, LIMBS.length);
    scene.robots.forEach(({ side, number }, robot) =>
      this.table.setPaint(robot, colour.set(TEAM_COLOURS[side]), number),
    );
    this.meshes.forEach(({ geometry }) => geometry.dispose());
    this.meshes = this.looks.map(({ body, material }) => this.#mesh(body, material, scene.robots.length));
    this.group.clear();
    this.group.add(...this.meshes);
    this.setShadows(this.castsShadow);
  }

  /**
   * Updates the poses of all limbs.
   *
   * @param {RobotState[]} robots
   * @param {THREE.Vector3} eye camera position
   */
  update(robots, eye) {
    const scene = /** @type {Scene} */ (this.scene);
    robots.forEach((robot, i) => {
      computeLinkPoses(scene.models[scene.robots[i].type], robot.torso, robot.degrees, this.poses[i]);
    });
    for (const { robot, limb, link, fit } of this.places) {
      this.table.setPose(robot, limb, poseMatrix(this.poses[robot], link, matrix).multiply(fit));
    }
    this.table.send();
    if (this.#judgeDistances(eye)) {
      const robotsOf = [this.near, this.near.map((near) => !near), this.near.map(() => true)];
      this.meshes.forEach((mesh, index) => showRobots(mesh, robotsOf[index]));
    }
  }

  /**
   * Determines which robots are near.
   *
   * @param {THREE.Vector3} eye
   * @returns {boolean} whether the set has changed
   */
  #judgeDistances(eye) {
    const distances = this.poses.map(([x, y, z]) => Math.hypot(x - eye.x, y - eye.y, z - eye.z));
    const limit = Math.min(this.nearMetres, [...distances].sort((a, b) => a - b)[this.maxNear] ?? Infinity);
    const near = distances.map((distance) => distance < limit);
    const changed = near.length !== this.near.length || near.some((value, i) => value !== this.near[i]);
    this.near = near;
    return changed;
  }

  /**
   * @param {THREE.BufferGeometry} body
   * @param {THREE.Material} material
   * @param {number} robots maximum number of robots
   */
  #mesh(body, material, robots) {
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.index = body.index;
    geometry.attributes = {
      ...body.attributes,
      robot: new THREE.InstancedBufferAttribute(new Float32Array(robots), 1),
    };
    const mesh = new THREE.Mesh(geometry, material);
    mesh.customDepthMaterial = this.depthMaterial;
    mesh.userData.table = this.table;
    mesh.frustumCulled = false;
    mesh.visible = false;
    mesh.renderOrder = BEFORE_GROUND;
    return mesh;
  }
}

/**
 * Makes a mesh show only the selected robots.
 *
 * @param {THREE.Mesh} mesh
 * @param {boolean[]} shown
 */
function showRobots(mesh, shown) {
  const geometry = /** @type {THREE.InstancedBufferGeometry} */ (mesh.geometry);
  const rows = geometry.getAttribute('robot');
  let count = 0;
  shown.forEach((isShown, robot) => {
    if (isShown) {
      rows.setX(count++, robot);
    }
  });
  rows.needsUpdate = true;
  geometry.instanceCount = count;
  mesh.visible = count > 0;
}

/**
 * @param {import('../state/kinematics.js').RobotModel} model
 * @param {number} robot
 * @returns {Place[]}
 */
function placesOf(model, robot) {
  return model.links.map(({ name }, link) => ({ robot, limb: LIMBS.indexOf(name), link, fit: fitMatrix(model, link) }));
}

/**
 * @param {import('../state/kinematics.js').RobotModel} model
 * @param {number} link
 */
function fitMatrix(model, link) {
  const { scale, offset } = limbFit(model, link);
  return new THREE.Matrix4().makeScale(scale[0], scale[1], scale[2]).setPosition(offset[0], offset[1], offset[2]);
}

const colour = new THREE.Color();
const matrix = new THREE.Matrix4();
const position = new THREE.Vector3();
const rotation = new THREE.Quaternion();
const unit = new THREE.Vector3(1, 1, 1);

/**
 * @param {ArrayLike<number>} poses
 * @param {number} link
 * @param {THREE.Matrix4} target
 */
export function poseMatrix(poses, link, target) {
  const at = link * POSE;
  position.set(poses[at], poses[at + 1], poses[at + 2]);
  rotation.set(poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 3]);
  return target.compose(position, rotation, unit);
}
