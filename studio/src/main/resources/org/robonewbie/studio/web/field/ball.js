/** The ball: white with twelve dark pentagons, so that its rolling can be seen. */
import * as THREE from 'three';

/** Radius of SimSpark's ball in metres. */
export const BALL_RADIUS = 0.042;

/** Each edge of the icosahedron is cut into so many parts; a multiple of three gives exact pentagons. */
const PARTS = 9;

/** @returns {THREE.Mesh} */
export function ball() {
  const geometry = new THREE.IcosahedronGeometry(BALL_RADIUS, PARTS - 1);
  const corners = pentagonCentres();
  const places = geometry.getAttribute('position');
  const colours = new Float32Array(3 * places.count);
  const light = new THREE.Color(0xf8f9fa);
  const dark = new THREE.Color(0x1d2229);
  const centre = new THREE.Vector3();
  const corner = new THREE.Vector3();
  for (let i = 0; i < places.count; i += 3) {
    centre.set(0, 0, 0);
    for (let j = 0; j < 3; j++) {
      centre.add(corner.fromBufferAttribute(places, i + j));
    }
    centre.normalize();
    const colour = corners.some((direction) => direction.dot(centre) > 0.9365) ? dark : light;
    for (let j = 0; j < 3; j++) {
      colour.toArray(colours, 3 * (i + j));
    }
  }
  geometry.setAttribute('color', new THREE.BufferAttribute(colours, 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(new Float32Array(places.array), 3));
  geometry.normalizeNormals();
  const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ vertexColors: true }));
  mesh.castShadow = true;
  mesh.name = 'ball';
  return mesh;
}

function pentagonCentres() {
  const places = new THREE.IcosahedronGeometry(1, 0).getAttribute('position');
  return Array.from({ length: places.count }, (_, i) => new THREE.Vector3().fromBufferAttribute(places, i).normalize());
}
