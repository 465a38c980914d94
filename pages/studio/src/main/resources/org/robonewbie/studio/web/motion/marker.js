/** Markers on the robot: the frame of the limb under the pointer, the centre of mass and the support polygon. */
import * as THREE from 'three';
import { POSE } from '../state/kinematics.js';

/**
 * @typedef {import('../state/motion/body.js').Body} Body
 * @typedef {import('../state/motion/balance.js').Balance} Balance
 */

/** Colours that colour-blind viewers can distinguish. */
const STEADY = 0x1878d2;
const TIPPING = 0xe0560c;
const HIGHLIGHT = 0xffb000;
const OVER_GROUND = 0.003;

export class Marker {
  constructor() {
    this.group = new THREE.Group();
    this.frame = new THREE.LineSegments(
      new THREE.EdgesGeometry(new THREE.BoxGeometry(1, 1, 1)),
      new THREE.LineBasicMaterial({ color: HIGHLIGHT, depthTest: false, transparent: true }),
    );
    this.frame.renderOrder = 5;
    this.frame.visible = false;
    this.support = new THREE.Mesh(new THREE.BufferGeometry(), flat(0.34));
    this.edge = new THREE.LineLoop(new THREE.BufferGeometry(), new THREE.LineBasicMaterial());
    this.centre = new THREE.Mesh(new THREE.SphereGeometry(0.012, 16, 12), solid());
    this.plumb = new THREE.Line(
      new THREE.BufferGeometry(),
      new THREE.LineBasicMaterial({ depthTest: false, transparent: true }),
    );
    this.foot = new THREE.Mesh(new THREE.CircleGeometry(0.011, 20), flat(1));
    for (const part of [this.centre, this.plumb, this.foot]) {
      part.renderOrder = 4;
    }
    this.balance = new THREE.Group();
    this.balance.add(this.support, this.edge, this.centre, this.plumb, this.foot);
    this.group.add(this.frame, this.balance);
  }

  /**
   * @param {Body} body
   * @param {number} link index of a link, or -1
   * @param {Float64Array} poses
   */
  frameLink(body, link, poses) {
    this.frame.visible = link >= 0;
    if (link >= 0) {
      const at = link * POSE;
      const [x, y, z] = body.model.links[link].size;
      this.frame.scale.set(x * 1.12 + 0.006, y * 1.12 + 0.006, z * 1.08 + 0.006);
      this.frame.position.set(poses[at], poses[at + 1], poses[at + 2]);
      this.frame.quaternion.set(poses[at + 4], poses[at + 5], poses[at + 6], poses[at + 3]);
    }
  }

  /** @param {Balance | undefined} balance */
  setBalance(balance) {
    this.balance.visible = balance !== undefined;
    if (!balance) {
      return;
    }
    const colour = balance.margin >= 0 ? STEADY : TIPPING;
    const [x, y, z] = balance.centre;
    for (const part of [this.support, this.edge, this.centre, this.plumb, this.foot]) {
      /** @type {THREE.MeshBasicMaterial} */ (part.material).color.set(colour);
    }
    this.#setSupport(balance.support);
    this.centre.position.set(x, y, z);
    this.plumb.geometry.setFromPoints([new THREE.Vector3(x, y, z), new THREE.Vector3(x, y, OVER_GROUND)]);
    this.foot.position.set(x, y, 2 * OVER_GROUND);
  }

  /** Shows the support polygon; a robot in the air or on an edge has none. @param {readonly number[][]} support */
  #setSupport(support) {
    const isArea = support.length >= 3;
    this.support.visible = isArea;
    this.edge.visible = isArea;
    if (isArea) {
      this.support.geometry.dispose();
      this.support.geometry = new THREE.ShapeGeometry(
        new THREE.Shape(support.map(([x, y]) => new THREE.Vector2(x, y))),
      );
      this.support.position.z = OVER_GROUND;
      this.edge.geometry.dispose();
      this.edge.geometry = new THREE.BufferGeometry().setFromPoints(
        support.map(([x, y]) => new THREE.Vector3(x, y, OVER_GROUND)),
      );
    }
  }
}

/** @param {number} opacity */
function flat(opacity) {
  return new THREE.MeshBasicMaterial({ transparent: true, opacity, depthWrite: false, side: THREE.DoubleSide });
}

function solid() {
  return new THREE.MeshBasicMaterial({ depthTest: false, transparent: true });
}
