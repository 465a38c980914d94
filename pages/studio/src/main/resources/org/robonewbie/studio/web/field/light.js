/** Lights and sky: the same sun in both themes, a brighter sky in the light one. */
import * as THREE from 'three';
import { flatMaterial, screenColour } from './flat-material.js';

/**
 * @typedef {object} Palette
 * @property {number} sky colour of the sky at the horizon
 * @property {number} zenith colour of the sky at the zenith
 * @property {number} surround ground around the pitch
 * @property {number} plain distant ground
 * @property {number} grass
 * @property {number} grassStripe
 * @property {number} line
 * @property {number} skyLight intensity of the sky light
 * @property {number} sunLight
 */

/** @type {{light: Palette, dark: Palette}} */
export const PALETTES = {
  light: {
    sky: 0xe9eff3,
    zenith: 0xb4cfe6,
    surround: 0x9db09f,
    plain: 0xb3c1b5,
    grass: 0x55a362,
    grassStripe: 0x5cab69,
    line: 0xffffff,
    skyLight: 1.55,
    sunLight: 2.1,
  },
  dark: {
    sky: 0x232c36,
    zenith: 0x0d1217,
    surround: 0x1a241f,
    plain: 0x18201d,
    grass: 0x2d6a3c,
    grassStripe: 0x327243,
    line: 0xe6ece8,
    skyLight: 1.15,
    sunLight: 2.0,
  },
};

/** Direction of the sun. */
export const SUN = new THREE.Vector3(3, -5, 8);

/** Half the width of the area in which shadows are drawn, per metre of the camera's distance. */
const SHADOW_REACH = 0.6;
const MIN_SHADOW_METRES = 2;
const SKY_RADIUS = 150;
const AFTER_ALL_GROUND = 2;

export class Light {
  /** @param {THREE.Scene} scene */
  constructor(scene) {
    this.sky = new THREE.HemisphereLight(0xffffff, 0x7d9482, 1);
    this.sky.position.set(0, 0, 1);
    this.sun = new THREE.DirectionalLight(0xfff4e2, 1);
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.radius = 3;
    this.sun.shadow.bias = -0.0004;
    this.sun.shadow.normalBias = 0.01;
    this.dome = skyDome();
    scene.add(this.dome, this.sky, this.sun, this.sun.target);
    this.shine([0, 0, 0], new THREE.Vector3());
  }

  /** @param {Palette} palette */
  setPalette(palette) {
    this.sky.intensity = palette.skyLight;
    this.sun.intensity = palette.sunLight;
    paintDome(this.dome, palette);
  }

  /**
   * Moves the sun and the sky with the view, so that shadows are sharp at the target and the sky dome stays out of reach.
   *
   * @param {number[]} target point that the camera looks at
   * @param {THREE.Vector3} eye
   */
  shine(target, eye) {
    this.dome.position.copy(eye);
    this.sun.target.position.set(target[0], target[1], 0);
    this.sun.position.addVectors(this.sun.target.position, SUN);
    const reach = Math.max(MIN_SHADOW_METRES, SHADOW_REACH * eye.distanceTo(this.sun.target.position));
    Object.assign(this.sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 1, far: 40 });
    this.sun.shadow.camera.updateProjectionMatrix();
  }
}

/** Creates the sky dome, bright at the horizon and deeper above; it must move with the camera. */
function skyDome() {
  const geometry = new THREE.SphereGeometry(SKY_RADIUS, 12, 24).rotateX(Math.PI / 2);
  const count = geometry.getAttribute('position').count;
  geometry.setAttribute('color', new THREE.BufferAttribute(new Float32Array(3 * count), 3));
  const dome = new THREE.Mesh(geometry, flatMaterial());
  dome.material.side = THREE.BackSide;
  dome.material.depthWrite = false;
  dome.renderOrder = AFTER_ALL_GROUND;
  return dome;
}

/**
 * @param {THREE.Mesh} dome
 * @param {Palette} palette
 */
function paintDome(dome, palette) {
  const places = dome.geometry.getAttribute('position');
  const colours = dome.geometry.getAttribute('color');
  const [plain, horizon, zenith] = [palette.plain, palette.sky, palette.zenith].map(screenColour);
  const colour = new THREE.Color();
  for (let i = 0; i < places.count; i++) {
    const height = Math.min(1, (places.getZ(i) / SKY_RADIUS) * 1.5);
    if (height < -0.01) {
      colour.copy(plain);
    } else {
      colour.lerpColors(horizon, zenith, Math.sqrt(Math.max(0, height)));
    }
    colours.setXYZ(i, colour.r, colour.g, colour.b);
  }
  colours.needsUpdate = true;
}

/**
 * Creates the environment map of a bright room, which glossy shells reflect.
 *
 * @param {THREE.WebGLRenderer} renderer
 * @returns {THREE.Texture | null} null without WebGL
 */
export function roomReflections(renderer) {
  if (!(renderer instanceof THREE.WebGLRenderer)) {
    return null;
  }
  const room = new THREE.Scene();
  room.background = new THREE.Color(0x98a6b0);
  /** @param {number} x @param {number} y @param {number} z @param {number} size @param {number} glow */
  const addPanel = (x, y, z, size, glow) => {
    const material = new THREE.MeshBasicMaterial({ color: new THREE.Color(glow, glow, glow), side: THREE.DoubleSide });
    const mesh = new THREE.Mesh(new THREE.PlaneGeometry(size, size), material);
    mesh.position.set(x, y, z);
    mesh.lookAt(0, 0, 0);
    room.add(mesh);
  };
  addPanel(0, 0, 5, 6, 3);
  addPanel(-5, -4, 3, 3, 4);
  addPanel(5, 3, 2, 2.5, 2);
  addPanel(0, 0, -5, 14, 0.12);
  const generator = new THREE.PMREMGenerator(renderer);
  const texture = generator.fromScene(room, 0.03).texture;
  generator.dispose();
  return texture;
}
