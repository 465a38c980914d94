/** The ring on the ground around the object under the pointer, and the arrow that shows the robot's new direction or the ball's flight. */
import * as THREE from 'three';

const HEIGHT = 0.014;
const SEGMENTS = 48;
const QUIET = 0.45;
const BUSY = 0.95;

/** Sizes of the arrow, as fractions of the ring's radius. */
const SHAFT = 0.2;
const HEAD = 0.55;

export class Ring {
  constructor() {
    const look = { transparent: true, depthWrite: false, toneMapped: false, side: THREE.DoubleSide };
    this.material = new THREE.MeshBasicMaterial({ color: 0xffffff, ...look });
    this.circle = new THREE.Mesh(new THREE.RingGeometry(0.88, 1.08, SEGMENTS), this.material);
    this.shaft = new THREE.Mesh(new THREE.PlaneGeometry(1, 1).translate(0.5, 0, 0), this.material);
    this.head = new THREE.Mesh(headShape(), this.material);
    this.arrow = new THREE.Group();
    this.arrow.add(this.shaft, this.head);
    this.group = new THREE.Group();
    this.group.name = 'ring';
    this.group.renderOrder = 1;
    this.group.add(this.circle, this.arrow);
    this.hide();
  }

  hide() {
    this.group.visible = false;
  }

  /**
   * @param {ArrayLike<number>} centre
   * @param {number} radius metres
   * @param {object} [sign]
   * @param {number} [sign.degrees] direction of the arrow; no arrow if omitted
   * @param {number} [sign.length] distance of its tip from the centre, metres
   * @param {boolean} [sign.busy] whether it is being dragged or hovered over
   */
  show(centre, radius, { degrees, length = 1.5 * radius, busy = false } = {}) {
    this.group.visible = true;
    this.group.position.set(centre[0], centre[1], HEIGHT);
    this.circle.scale.setScalar(radius);
    this.material.opacity = busy ? BUSY : QUIET;
    this.arrow.visible = degrees !== undefined;
    this.arrow.rotation.z = ((degrees ?? 0) * Math.PI) / 180;
    const neck = Math.max(radius, length - HEAD * radius);
    this.shaft.position.x = radius;
    this.shaft.scale.set(Math.max(0.001, neck - radius), SHAFT * radius, 1);
    this.head.position.x = neck;
    this.head.scale.setScalar(HEAD * radius);
  }
}

/** Creates a triangle with its tip at x = 1. */
function headShape() {
  const shape = new THREE.Shape();
  shape.moveTo(0, -0.6);
  shape.lineTo(1, 0);
  shape.lineTo(0, 0.6);
  return new THREE.ShapeGeometry(shape);
}
