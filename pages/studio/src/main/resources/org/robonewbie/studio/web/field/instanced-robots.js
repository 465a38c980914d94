/** Draws all robots in the scene: three draw calls for each kind of robot, regardless of their number. */
import * as THREE from 'three';
import { isNao } from '../state/figure.js';
import { computeLinkPoses, POSE } from '../state/kinematics.js';
import { modelDesign } from './model-design.js';
import { NAO_DESIGN } from './nao-design.js';
import { RobotBatch } from './robot-batch.js';

/**
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../live/state-frame.js').RobotState} RobotState
 * @typedef {import('../state/kinematics.js').RobotModel} RobotModel
 * @typedef {import('../state/quality.js').Quality} Quality
 * @typedef {import('./robot-batch.js').Design} Design
 */

export class InstancedRobots {
  /** @param {() => THREE.Material} [material] creates the material of all bodies; by default it depends on the quality */
  constructor(material) {
    this.material = material;
    this.group = new THREE.Group();
    /** Batches of the current scene, with the indices of their robots. @type {Map<Design, {batch: RobotBatch, robots: number[]}>} */
    this.batches = new Map();
    /** @type {Float32Array[]} poses of all links of each robot */
    this.poses = [];
    /** @type {Scene | undefined} */
    this.scene = undefined;
    /** @type {Quality | undefined} */
    this.quality = undefined;
    this.castsShadow = false;
  }

  /** All meshes of the scene's robots. */
  get meshes() {
    return [...this.batches.values()].flatMap(({ batch }) => batch.meshes);
  }

  /** @param {Quality} quality */
  setQuality(quality) {
    this.quality = quality;
    this.batches.forEach(({ batch }) => batch.setQuality(quality));
  }

  /** @param {boolean} casts */
  setShadows(casts) {
    this.castsShadow = casts;
    this.batches.forEach(({ batch }) => batch.setShadows(casts));
  }

  /** @param {Scene} scene */
  setScene(scene) {
    this.scene = scene;
    this.poses = scene.robots.map(({ type }) => new Float32Array(scene.models[type].links.length * POSE));
    const designs = scene.robots.map(({ type }) => designOf(scene.models[type]));
    for (const [design, { batch }] of this.batches) {
      if (!designs.includes(design)) {
        batch.setRobots([]);
        this.batches.delete(design);
      }
    }
    for (const design of new Set(designs)) {
      const robots = designs.flatMap((each, robot) => (each === design ? [robot] : []));
      const batch = this.batches.get(design)?.batch ?? this.#newBatch(design);
      batch.setRobots(
        robots.map((robot) => ({ player: scene.robots[robot], model: scene.models[scene.robots[robot].type] })),
      );
      this.batches.set(design, { batch, robots });
    }
    this.group.clear();
    this.batches.forEach(({ batch }) => this.group.add(batch.group));
  }

  /** @param {Design} design */
  #newBatch(design) {
    const batch = new RobotBatch(design, this.material);
    if (this.quality) {
      batch.setQuality(this.quality);
    }
    batch.setShadows(this.castsShadow);
    return batch;
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
    for (const { batch, robots: own } of this.batches.values()) {
      batch.update(
        own.map((robot) => this.poses[robot]),
        eye,
      );
    }
  }
}

/** Designs by the JSON of the model, because each scene message contains new model objects. @type {Map<string, Design>} */
const designs = new Map();

/** @param {RobotModel} model @returns {Design} */
function designOf(model) {
  if (isNao(model)) {
    return NAO_DESIGN;
  }
  const key = JSON.stringify(model);
  const design = designs.get(key) ?? modelDesign(model);
  designs.set(key, design);
  return design;
}
