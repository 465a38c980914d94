/**
 * Unlit material: shows its colours exactly and fades into the haze at the horizon. Ground and sky fill most of the picture, so without a
 * graphics card they dominate the rendering time.
 */
import * as THREE from 'three';

/** Distances at which the haze on the beginners' pitch begins and is complete, in metres. */
const HAZE_METRES = [9, 38];
const BEGINNERS_LENGTH = 12;

/**
 * Returns the distances at which the haze begins and is complete, in metres. They grow with the pitch, so that an overview shows all of it.
 *
 * @param {{length: number}} field
 */
export function hazeMetres({ length }) {
  return HAZE_METRES.map((metres) => metres * Math.max(1, length / BEGINNERS_LENGTH));
}

/**
 * @param {{colour: number, metres: number[]}} [haze] no haze if omitted
 * @returns {THREE.ShaderMaterial} a material for geometries with the attribute `color`; see {@link screenColour}
 */
export function flatMaterial(haze) {
  const [near, far] = (haze?.metres ?? [0, 0]).map((metres) => metres.toFixed(1));
  return new THREE.ShaderMaterial({
    vertexColors: true,
    uniforms: { haze: { value: screenColour(haze?.colour ?? 0) } },
    vertexShader: `
      varying vec3 tint;
      varying float metres;
      void main() {
        tint = color;
        vec4 place = modelViewMatrix * vec4(position, 1.0);
        metres = -place.z;
        gl_Position = projectionMatrix * place;
      }`,
    fragmentShader: `
      uniform vec3 haze;
      varying vec3 tint;
      varying float metres;
      void main() {
        gl_FragColor = vec4(${haze === undefined ? 'tint' : `mix(tint, haze, smoothstep(${near}, ${far}, metres))`}, 1.0);
      }`,
  });
}

/**
 * Converts a colour so that the screen shows exactly this value.
 *
 * @param {number} hex
 * @returns {THREE.Color}
 */
export function screenColour(hex) {
  return new THREE.Color().setHex(hex, THREE.LinearSRGBColorSpace);
}

/**
 * Gives all vertices of a geometry one colour.
 *
 * @param {THREE.BufferGeometry} geometry
 * @param {number} hex
 * @returns {THREE.BufferGeometry} the same geometry
 */
export function tinted(geometry, hex) {
  const { r, g, b } = screenColour(hex);
  const corners = Array.from({ length: geometry.getAttribute('position').count }, () => [r, g, b]);
  return geometry.setAttribute('color', new THREE.Float32BufferAttribute(corners.flat(), 3));
}
