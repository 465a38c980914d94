/** The ball: white with twelve dark pentagons, so that its rotation is visible. */
import * as THREE from 'three';
import { BALL_RADIUS } from '../state/ball-radius.js';

/** Segments per edge of the icosahedron; a multiple of three gives exact pentagons. */
const PARTS = { fine: 9, coarse: 6, tiny: 3 };

/** @returns {THREE.Mesh} */
export function ball() {
  const mesh = new THREE.Mesh(ballShape('fine'), new THREE.MeshLambertMaterial({ vertexColors: true }));
  mesh.castShadow = true;
  mesh.name = 'ball';
  return mesh;
}

/**
 * @param {import('../state/quality.js').Detail} detail
 * @returns {THREE.BufferGeometry}
 */
export function ballShape(detail) {
  const geometry = new THREE.IcosahedronGeometry(BALL_RADIUS, PARTS[detail] - 1);
  const corners = pentagonCentres();
  const places = geometry.getAttribute('position');
  const colours = new Float32Array(3 * places.count);
  const light = new THREE.Color(0xf8f9fa);
  const dark = new THREE.Color(0x1d2229);
  const [a, b, c] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  for (let i = 0; i < places.count; i += 3) {
    [a, b, c].forEach((corner, j) => corner.fromBufferAttribute(places, i + j));
    const colour = isInPentagon(a.add(b).add(c).normalize(), corners) ? dark : light;
    [0, 1, 2].forEach((j) => colour.toArray(colours, 3 * (i + j)));
  }
  geometry.setAttribute('color', new THREE.BufferAttribute(colours, 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(new Float32Array(places.array), 3));
  geometry.normalizeNormals();
  return geometry;
}

/** Returns the vertices of the icosahedron, each of which is the centre of a dark pentagon. */
function pentagonCentres() {
  const places = new THREE.IcosahedronGeometry(1, 0).getAttribute('position');
  /** @type {Map<string, THREE.Vector3>} */
  const corners = new Map();
  for (let i = 0; i < places.count; i++) {
    const corner = new THREE.Vector3().fromBufferAttribute(places, i);
    corners.set(
      corner
        .toArray()
        .map((value) => value.toFixed(3))
        .join(),
      corner,
    );
  }
  return [...corners.values()];
}

/**
 * A football is a truncated icosahedron, cut at a third of each edge: a direction whose barycentric weight for one vertex exceeds two
 * thirds lies in a pentagon.
 *
 * @param {THREE.Vector3} direction
 * @param {THREE.Vector3[]} corners
 */
function isInPentagon(direction, corners) {
  const nearest = [...corners].sort((a, b) => b.dot(direction) - a.dot(direction)).slice(0, 3);
  const triangle = new THREE.Matrix3();
  triangle.set(
    nearest[0].x,
    nearest[1].x,
    nearest[2].x,
    nearest[0].y,
    nearest[1].y,
    nearest[2].y,
    nearest[0].z,
    nearest[1].z,
    nearest[2].z,
  );
  const weights = direction.clone().applyMatrix3(triangle.invert());
  return weights.x / (weights.x + weights.y + weights.z) > 2 / 3;
}
