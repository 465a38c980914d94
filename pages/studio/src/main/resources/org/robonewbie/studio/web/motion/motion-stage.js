/** The motion editor's 3D view: the robot, ghosts of the neighbouring keyframes, centre of mass and support polygon. */
import * as THREE from 'three';
import { CameraController } from '../field/camera-controller.js';
import { rayAt } from '../field/field-view.js';
import { Light, PALETTES, roomReflections } from '../field/light.js';
import { ghostMaterial } from '../field/materials.js';
import { isWebGl, opaqueRenderer } from '../field/renderer.js';
import { InstancedRobots } from '../field/instanced-robots.js';
import { LimbPaint } from './limb-paint.js';
import { Marker } from './marker.js';
import { figureOf } from '../state/figure.js';
import { hingeDegrees } from '../state/motion/body.js';

/**
 * @typedef {import('../state/motion/body.js').Body} Body
 * @typedef {import('../state/quality.js').Quality} Quality
 *
 * @typedef {object} Figure a robot in the picture
 * @property {ArrayLike<number>} torso
 * @property {readonly number[]} hinges
 */

const FLOORS = { light: { ground: 0xd3dce3, line: 0xb4c0ca }, dark: { ground: 0x1d252d, line: 0x35414c } };
const FLOOR_METRES = 3;
const NAO_METRES = 0.58;

/** Pose of a hidden ghost. */
const FAR_BELOW = [0, 0, -50, 1, 0, 0, 0];

export class MotionStage {
  /**
   * @param {HTMLElement} stage
   * @param {Body} body
   * @param {Quality} quality
   */
  constructor(stage, body, quality) {
    this.stage = stage;
    this.quality = quality;
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(38, 1, 0.02, 160);
    this.camera.up.set(0, 0, 1);
    this.light = new Light(this.scene);
    this.renderer = opaqueRenderer();
    this.robot = this.#instances(1);
    this.ghosts = this.#instances(2, ghostMaterial());
    this.ghosts.group.visible = false;
    this.marker = new Marker();
    this.paint = new LimbPaint();
    this.floor = new THREE.Group();
    this.scene.add(this.robot.group, this.ghosts.group, this.marker.group, this.paint.group, this.floor);
    this.scene.environment = quality.glossy ? roomReflections(this.renderer) : null;
    this.scene.environmentIntensity = 0.5;
    stage.append(this.renderer.domElement);
    this.body = body;
    this.#showBody();
    this.cameraController = new CameraController(this.camera);
    this.home();
    this.cameraController.jumpTo(this.cameraController.view);
  }

  /** Resets the view: from the front, slightly from the side. */
  home() {
    const height = figureOf(this.body.model).height / NAO_METRES;
    const target = [0, 0, 0.31 * height];
    this.cameraController.view = { target, azimuthDegrees: 62, elevationDegrees: 12, distance: 1.35 * height };
  }

  /** Shows another robot. @param {Body} body */
  setBody(body) {
    if (body !== this.body) {
      this.body = body;
      this.#showBody();
      this.home();
    }
  }

  #showBody() {
    for (const instances of [this.robot, this.ghosts]) {
      const robots = Array.from({ length: instances === this.robot ? 1 : 2 }, (_, id) => ({
        id,
        team: '',
        side: /** @type {'left' | 'right'} */ (id === 0 ? 'left' : 'right'),
        number: 0,
        type: 'TYPE_0',
      }));
      instances.setScene(/** @type {any} */ ({ robots, models: { TYPE_0: this.body.model } }));
    }
    this.ghosts.meshes.forEach((mesh) => {
      mesh.renderOrder = 2;
    });
    this.paint.setBody(this.body);
  }

  /** @param {'light' | 'dark'} theme */
  setTheme(theme) {
    this.light.setPalette(PALETTES[theme]);
    this.scene.fog = new THREE.Fog(PALETTES[theme].sky, 2.5, 7);
    this.floor.clear();
    const { ground, line } = FLOORS[theme];
    const plane = new THREE.Mesh(
      new THREE.CircleGeometry(8, 48),
      new THREE.MeshBasicMaterial({
        color: ground,
        polygonOffset: true,
        polygonOffsetFactor: 2,
        polygonOffsetUnits: 2,
      }),
    );
    const grid = new THREE.GridHelper(2 * FLOOR_METRES, 20 * FLOOR_METRES, line, line);
    grid.rotation.x = Math.PI / 2;
    this.floor.add(plane, grid);
  }

  resize() {
    const width = Math.max(1, this.stage.clientWidth);
    const height = Math.max(1, this.stage.clientHeight);
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, Math.max(1, this.quality.pixelRatio)));
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  /**
   * @param {Figure} figure
   * @param {Array<Figure | undefined>} ghosts the blue and the orange ghost
   */
  show(figure, ghosts) {
    this.robot.update([stateOf(figure)], this.camera.position);
    this.ghosts.group.visible = ghosts.some(Boolean);
    if (this.ghosts.group.visible) {
      const two = [ghosts[0], ghosts[1]].map((ghost) => ghost ?? { ...figure, torso: FAR_BELOW });
      this.ghosts.update(two.map(stateOf), this.camera.position);
    }
  }

  /**
   * @param {number} seconds since the last frame
   * @returns {boolean} whether the camera is still moving
   */
  draw(seconds) {
    const moves = this.cameraController.update([], seconds);
    this.light.shine(this.cameraController.shown.target, this.camera.position);
    this.renderer.render(this.scene, this.camera);
    return moves;
  }

  /**
   * Returns the ray through a point on the page.
   *
   * @param {number} clientX
   * @param {number} clientY
   * @returns {THREE.Ray}
   */
  rayAt(clientX, clientY) {
    return rayAt(this, clientX, clientY);
  }

  /** @param {number[]} point @returns {number[]} its position on the page */
  pageAt(point) {
    const box = this.stage.getBoundingClientRect();
    const place = new THREE.Vector3(point[0], point[1], point[2]).project(this.camera);
    return [box.left + ((place.x + 1) / 2) * box.width, box.top + ((1 - place.y) / 2) * box.height];
  }

  /** @param {number} count @param {THREE.Material} [material] */
  #instances(count, material) {
    const instances = new InstancedRobots(material && (() => material));
    instances.setQuality({
      ...this.quality,
      nearDetail: count === 1 && isWebGl(this.renderer) ? 'fine' : 'coarse',
      farDetail: 'coarse',
      nearMetres: 100,
      maxNear: 22,
    });
    return instances;
  }

  /** @param {readonly number[]} posture @param {ArrayLike<number>} torso @returns {Figure} */
  figure(posture, torso) {
    return { torso, hinges: hingeDegrees(this.body, posture) };
  }
}

/** @param {Figure} figure */
function stateOf({ torso, hinges }) {
  return { torso: Float32Array.from(torso), degrees: Float32Array.from(hinges) };
}
