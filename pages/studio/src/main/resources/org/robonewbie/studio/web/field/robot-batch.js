/** Draws all robots of one design in three draw calls, regardless of their number. */
import * as THREE from 'three';
import { POSE } from '../state/kinematics.js';
import { numberMaterial, robotMaterial, TEAM_COLOURS } from './materials.js';
import { RobotTable } from './robot-table.js';

/**
 * @typedef {import('../live/state-frame.js').Player} Player
 * @typedef {import('../state/kinematics.js').RobotModel} RobotModel
 * @typedef {import('../state/quality.js').Quality} Quality
 * @typedef {import('../state/quality.js').Detail} Detail
 *
 * @typedef {object} Design appearance of a kind of robot
 * @property {number} limbs number of kinds of limbs
 * @property {(detail: Detail) => THREE.BufferGeometry} body all limbs, with the attribute `limb`
 * @property {() => THREE.BufferGeometry | undefined} plates number plates, with the attribute `limb`; undefined for none
 * @property {(model: RobotModel) => Array<{limb: number, fit: THREE.Matrix4}>} limbsOf for each link its kind of limb, and the transformation
 *     that fits the design to the model
 *
 * @typedef {object} Place source and destination of a limb's pose
 * @property {number} robot index of the robot
 * @property {number} limb index of the kind of limb
 * @property {number} link index of the robot's link
 * @property {THREE.Matrix4} fit transformation that fits the design to the robot type
 */

/** Render order of the robots: before the ground, much of which they hide. */
const BEFORE_GROUND = -1;

export class RobotBatch {
  /**
   * @param {Design} design
   * @param {() => THREE.Material} [material] creates the material of all bodies; by default it depends on the quality
   */
  constructor(design, material) {
    this.design = design;
    this.group = new THREE.Group();
    this.table = new RobotTable();
    this.fixedMaterial = material && this.table.posed(material());
    this.numberMaterial = this.table.posed(numberMaterial());
    this.depthMaterial = this.table.posed(new THREE.MeshDepthMaterial({ depthPacking: THREE.RGBADepthPacking }));
    /** @type {Array<{body: THREE.BufferGeometry, material: THREE.Material}>} near robots, far robots, and all number plates */
    this.looks = [];
    /** @type {THREE.Mesh[]} one per look */
    this.meshes = [];
    /** @type {Place[]} */
    this.places = [];
    /** @type {boolean[]} whether each robot is near enough for the fine geometry */
    this.near = [];
    /** @type {Array<{player: Player, model: RobotModel}>} */
    this.robots = [];
    this.castsShadow = false;
    this.nearMetres = 0;
    this.maxNear = 0;
  }

  /** @param {Quality} quality */
  setQuality(quality) {
    this.nearMetres = quality.nearMetres;
    this.maxNear = quality.maxNear;
    const material = this.fixedMaterial ?? this.table.posed(robotMaterial(quality.glossy));
    const plates = this.design.plates();
    this.looks = [
      { body: this.design.body(quality.nearDetail), material },
      { body: this.design.body(quality.farDetail), material },
      ...(plates ? [{ body: plates, material: this.numberMaterial }] : []),
    ];
    this.setRobots(this.robots);
  }

  /** @param {boolean} casts */
  setShadows(casts) {
    this.castsShadow = casts;
    this.meshes.forEach((mesh, index) => {
      mesh.castShadow = casts && index < 2;
    });
  }

  /** @param {Array<{player: Player, model: RobotModel}>} robots */
  setRobots(robots) {
    this.robots = robots;
    this.near = [];
    this.places = robots.flatMap(({ model }, robot) =>
      this.design.limbsOf(model).map(({ limb, fit }, link) => ({ robot, limb, link, fit })),
    );
    this.table.clear(robots.length, this.design.limbs);
    robots.forEach(({ player: { side, number } }, robot) =>
      this.table.setPaint(robot, colour.set(TEAM_COLOURS[side]), number),
    );
    this.meshes.forEach(({ geometry }) => geometry.dispose());
    this.meshes =
      robots.length > 0 ? this.looks.map(({ body, material }) => this.#mesh(body, material, robots.length)) : [];
    this.group.clear();
    this.meshes.forEach((mesh) => this.group.add(mesh));
    this.setShadows(this.castsShadow);
  }

  /**
   * Updates the poses of all limbs.
   *
   * @param {Float32Array[]} poses poses of all links of each robot
   * @param {THREE.Vector3} eye camera position
   */
  update(poses, eye) {
    for (const { robot, limb, link, fit } of this.places) {
      this.table.setPose(robot, limb, poseMatrix(poses[robot], link, matrix).multiply(fit));
    }
    this.table.send();
    if (this.#judgeDistances(poses, eye)) {
      const robotsOf = [this.near, this.near.map((near) => !near), this.near.map(() => true)];
      this.meshes.forEach((mesh, index) => showRobots(mesh, robotsOf[index]));
    }
  }

  /**
   * Determines which robots are near.
   *
   * @param {Float32Array[]} poses
   * @param {THREE.Vector3} eye
   * @returns {boolean} whether the set has changed
   */
  #judgeDistances(poses, eye) {
    const distances = poses.map(([x, y, z]) => Math.hypot(x - eye.x, y - eye.y, z - eye.z));
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
