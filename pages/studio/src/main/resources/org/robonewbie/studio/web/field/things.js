/** Other objects on the pitch: boxes with dark edges; movable ones have a warmer colour. */
import * as THREE from 'three';

/** @typedef {import('../live/state-frame.js').Thing} Thing */

const FIXED = 0xa9aeb5;
const MOVABLE = 0xd8a24a;
const EDGE = 0x4a4238;

export class Things {
  constructor() {
    this.group = new THREE.Group();
    this.group.name = 'things';
    this.shown = '[]';
  }

  /** @param {readonly Thing[]} things */
  setThings(things) {
    const wanted = JSON.stringify(things);
    if (wanted !== this.shown) {
      this.shown = wanted;
      this.group.clear();
      things.forEach((thing) => this.group.add(box(thing)));
    }
  }

  /** @param {boolean} real whether the sun casts shadows */
  setShadows(real) {
    this.group.children.forEach((mesh) => {
      mesh.castShadow = real;
      mesh.receiveShadow = real;
    });
  }

  /** @param {readonly Float32Array[]} poses */
  update(poses) {
    this.group.children.forEach((mesh, i) => {
      mesh.visible = i < poses.length;
      if (mesh.visible) {
        const [x, y, z, rw, rx, ry, rz] = poses[i];
        mesh.position.set(x, y, z);
        mesh.quaternion.set(rx, ry, rz, rw);
      }
    });
  }
}

/** @param {Thing} thing @returns {THREE.Mesh} */
function box({ name, size, movable }) {
  const geometry = new THREE.BoxGeometry(...size);
  const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color: movable ? MOVABLE : FIXED }));
  const edges = new THREE.LineBasicMaterial({ color: EDGE });
  mesh.add(new THREE.LineSegments(new THREE.EdgesGeometry(geometry), edges));
  mesh.name = name;
  return mesh;
}
