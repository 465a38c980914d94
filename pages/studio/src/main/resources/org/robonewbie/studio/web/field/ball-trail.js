/** Ball trail: fading dots; the wider their spacing, the faster the ball was. */
import * as THREE from 'three';
import { BallPath } from '../state/ball-path.js';

const MAX_DOTS = 400;
const DOT_PIXELS = 5;
const COLOUR = new THREE.Color(0xffe14d);

export class BallTrail {
  #path = new BallPath();
  #places = new Float32Array(3 * MAX_DOTS);
  #colours = new Float32Array(4 * MAX_DOTS);

  constructor() {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(this.#places, 3));
    geometry.setAttribute('color', new THREE.BufferAttribute(this.#colours, 4));
    const look = {
      vertexColors: true,
      transparent: true,
      depthWrite: false,
      sizeAttenuation: false,
      toneMapped: false,
    };
    this.dots = new THREE.Points(geometry, new THREE.PointsMaterial({ size: DOT_PIXELS, ...look }));
    this.dots.frustumCulled = false;
    this.dots.name = 'ball-trail';
    this.isOn = true;
    this.#draw([]);
  }

  clear() {
    this.#path.clear();
    this.#draw([]);
  }

  /** @param {number} cycle @param {ArrayLike<number>} ball pose */
  follow(cycle, ball) {
    this.#path.add(cycle, ball);
    this.#draw(this.isOn ? this.#path.trail.slice(-MAX_DOTS) : []);
  }

  /** Keeps the dots the same size on the page at every quality level. @param {number} pixelRatio */
  setPixelRatio(pixelRatio) {
    this.dots.material.size = Math.max(2, DOT_PIXELS * pixelRatio);
  }

  /** @param {Array<{place: number[], freshness: number}>} trail */
  #draw(trail) {
    const paint = COLOUR.toArray();
    trail.forEach(({ place, freshness }, i) => {
      this.#places.set(place, 3 * i);
      this.#colours.set([...paint, freshness], 4 * i);
    });
    const { position, color } = this.dots.geometry.attributes;
    position.needsUpdate = true;
    color.needsUpdate = true;
    this.dots.geometry.setDrawRange(0, trail.length);
    this.dots.visible = trail.length > 0;
  }
}
