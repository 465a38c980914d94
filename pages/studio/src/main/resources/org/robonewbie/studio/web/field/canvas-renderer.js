/**
 * Draws 3D scenes on a 2D canvas, for browsers without WebGL. Faces are painted from back to front in one colour each, without textures and
 * shadows. It has the methods of `THREE.WebGLRenderer` that the views use.
 */
import * as THREE from 'three';
import { Faces } from './faces.js';

export class CanvasRenderer {
  domElement = document.createElement('canvas');
  shadowMap = { enabled: false };
  info = { autoReset: true, reset: () => {}, render: { calls: 0 } };
  #pen = /** @type {CanvasRenderingContext2D} */ (this.domElement.getContext('2d', { alpha: false }));
  #size = new THREE.Vector2(1, 1);
  #pixelRatio = 1;

  /** @param {number} ratio */
  setPixelRatio(ratio) {
    this.#pixelRatio = ratio;
    this.setSize(this.#size.x, this.#size.y);
  }

  getPixelRatio() {
    return this.#pixelRatio;
  }

  /** @param {number} width @param {number} height in page pixels */
  setSize(width, height) {
    this.#size.set(width, height);
    this.domElement.width = Math.max(1, Math.floor(width * this.#pixelRatio));
    this.domElement.height = Math.max(1, Math.floor(height * this.#pixelRatio));
    Object.assign(this.domElement.style, { width: `${width}px`, height: `${height}px` });
  }

  /** @param {THREE.Vector2} target @returns {THREE.Vector2} the target, set to the size in page pixels */
  getSize(target) {
    return target.copy(this.#size);
  }

  dispose() {}

  forceContextLoss() {}

  /** @param {THREE.Scene} scene @param {THREE.PerspectiveCamera} camera */
  render(scene, camera) {
    const { width, height } = this.domElement;
    scene.updateMatrixWorld();
    camera.updateMatrixWorld();
    const faces = new Faces(camera, width, height);
    scene.traverseVisible((object) => faces.add(object));
    this.#pen.lineWidth = this.#pixelRatio;
    this.#pen.fillStyle = scene.fog?.color.getStyle() ?? 'black';
    this.#pen.fillRect(0, 0, width, height);
    this.#paint(faces.sorted);
  }

  /**
   * Paints faces. Neighbouring faces in the same style share a path, which hides the seams between them.
   *
   * @param {import('./faces.js').Face[]} faces
   */
  #paint(faces) {
    let style = '';
    let isLine = false;
    const flush = () => (isLine ? this.#pen.stroke() : this.#pen.fill());
    for (const face of faces) {
      if (face.style !== style || face.isLine !== isLine || face.picture) {
        flush();
        this.#pen.beginPath();
        ({ style, isLine } = face);
        this.#pen[isLine ? 'strokeStyle' : 'fillStyle'] = style;
      }
      this.#trace(face);
    }
    flush();
    this.#pen.beginPath();
  }

  /** @param {import('./faces.js').Face} face */
  #trace({ points, isLine, picture }) {
    if (picture) {
      const [left, top, right, bottom] = points;
      this.#pen.drawImage(picture, left, top, right - left, bottom - top);
      return;
    }
    this.#pen.moveTo(points[0], points[1]);
    for (let i = 2; i < points.length; i += 2) {
      this.#pen.lineTo(points[i], points[i + 1]);
    }
    if (!isLine) {
      this.#pen.closePath();
    }
  }
}
