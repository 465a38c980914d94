/** Light and air: the same sun in both themes, a brighter sky in the light one. */
import * as THREE from 'three';

/**
 * @typedef {object} Palette
 * @property {number} sky
 * @property {number} surround
 * @property {number} grass
 * @property {number} grassStripe
 * @property {number} line
 * @property {number} skyLight how bright the sky shines
 * @property {number} sunLight
 */

/** @type {{light: Palette, dark: Palette}} */
export const PALETTES = {
  light: { sky: 0xdfe8ef, surround: 0xb9c7cf, grass: 0x55a362, grassStripe: 0x5cab69, line: 0xffffff, skyLight: 1.55, sunLight: 2.1 },
  dark: { sky: 0x141a21, surround: 0x1d252d, grass: 0x2d6a3c, grassStripe: 0x327243, line: 0xe6ece8, skyLight: 1.15, sunLight: 2.0 },
};

const SHADOW_REACH = 2.2;

export class Light {
  /** @param {THREE.Scene} scene */
  constructor(scene) {
    this.scene = scene;
    this.sky = new THREE.HemisphereLight(0xffffff, 0x7d9482, 1);
    this.sky.position.set(0, 0, 1);
    this.sun = new THREE.DirectionalLight(0xfff4e2, 1);
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.radius = 3;
    this.sun.shadow.bias = -0.0004;
    this.sun.shadow.normalBias = 0.01;
    Object.assign(this.sun.shadow.camera, {
      left: -SHADOW_REACH,
      right: SHADOW_REACH,
      top: SHADOW_REACH,
      bottom: -SHADOW_REACH,
      near: 1,
      far: 20,
    });
    scene.add(this.sky, this.sun, this.sun.target);
    this.shine([0, 0, 0]);
  }

  /** @param {Palette} palette */
  setPalette(palette) {
    this.sky.intensity = palette.skyLight;
    this.sun.intensity = palette.sunLight;
    this.scene.background = new THREE.Color(palette.sky);
    this.scene.fog = new THREE.Fog(palette.sky, 14, 60);
  }

  /**
   * Takes the sun along, so that its shadows are sharp where the eye looks.
   *
   * @param {number[]} target
   */
  shine(target) {
    this.sun.position.set(target[0] - 4, target[1] - 5, 9);
    this.sun.target.position.set(target[0], target[1], 0);
  }
}

/**
 * A bright room that mirrors in glossy shells.
 *
 * @param {THREE.WebGLRenderer} renderer
 * @returns {THREE.Texture}
 */
export function roomReflections(renderer) {
  const room = new THREE.Scene();
  room.background = new THREE.Color(0x98a6b0);
  /** @param {number} x @param {number} y @param {number} z @param {number} size @param {number} glow */
  const lamp = (x, y, z, size, glow) => {
    const material = new THREE.MeshBasicMaterial({ color: new THREE.Color(glow, glow, glow), side: THREE.DoubleSide });
    const mesh = new THREE.Mesh(new THREE.PlaneGeometry(size, size), material);
    mesh.position.set(x, y, z);
    mesh.lookAt(0, 0, 0);
    room.add(mesh);
  };
  lamp(0, 0, 5, 6, 3);
  lamp(-5, -4, 3, 3, 4);
  lamp(5, 3, 2, 2.5, 2);
  lamp(0, 0, -5, 14, 0.12);
  const generator = new THREE.PMREMGenerator(renderer);
  const texture = generator.fromScene(room, 0.03).texture;
  generator.dispose();
  return texture;
}
