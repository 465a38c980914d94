/** Highlights limbs with faults by overlaying the simulator's collision shapes. */
import * as THREE from 'three';
import { POSE } from '../state/kinematics.js';

/**
 * @typedef {import('../state/motion/body.js').Body} Body
 * @typedef {import('../state/motion/faults.js').Fault} Fault
 */

/** The colours of the timeline's marks, in ascending priority. @type {Array<{kind: Fault['kind'], colour: number}>} */
const COLOURS = [
  { kind: 'limit', colour: 0xffc400 },
  { kind: 'lag', colour: 0xff8a1f },
  { kind: 'speed', colour: 0xff7a00 },
  { kind: 'collision', colour: 0xb04ff0 },
  { kind: 'range', colour: 0xff2a1f },
];
const LARGER = 0.006;

export class LimbPaint {
  constructor() {
    this.group = new THREE.Group();
    /** @type {THREE.Mesh[]} */
    this.shapes = [];
  }

  /** @param {Body} body */
  setBody(body) {
    this.group.clear();
    this.shapes = body.model.links.map((link, i) => shapeOf(link.size, body.links[i]));
    this.group.add(...this.shapes);
  }

  /** @param {readonly Fault[]} faults @param {Float64Array} poses */
  show(faults, poses) {
    this.shapes.forEach((shape, link) => {
      const found = COLOURS.findLast(({ kind }) =>
        faults.some((fault) => fault.kind === kind && fault.links.includes(link)),
      );
      shape.visible = found !== undefined;
      if (found) {
        const at = link * POSE;
        /** @type {THREE.MeshBasicMaterial} */ (shape.material).color.set(found.colour);
        shape.position.set(poses[at], poses[at + 1], poses[at + 2]);
        shape.quaternion.set(poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 3]);
      }
    });
  }
}

/** @param {number[]} size @param {import('../state/motion/body.js').BodyLink} link */
function shapeOf([x, y, z], { radius, length = 0 }) {
  const form = radius
    ? new THREE.CapsuleGeometry(radius + LARGER, length, 6, 20).rotateX(Math.PI / 2)
    : new THREE.BoxGeometry(x + LARGER, y + LARGER, z + LARGER);
  const material = new THREE.MeshBasicMaterial({ transparent: true, opacity: 0.5, depthTest: false });
  const shape = new THREE.Mesh(form, material);
  shape.renderOrder = 3;
  shape.visible = false;
  return shape;
}
