/** Puts painted pieces together to one body, so that each limb of all robots is one draw call. */
import * as THREE from 'three';

/**
 * @typedef {'shell' | 'joint' | 'trim' | 'team' | 'eye' | 'black'} Paint
 *
 * @typedef {object} Piece
 * @property {THREE.BufferGeometry} geometry
 * @property {Paint} paint
 */

/** @type {Record<Paint, {colour: number, team: number, glow: number}>} */
const PAINTS = {
  shell: { colour: 0xf4f6f7, team: 0, glow: 0 },
  joint: { colour: 0x30353b, team: 0, glow: 0 },
  trim: { colour: 0xaab2ba, team: 0, glow: 0 },
  team: { colour: 0xffffff, team: 1, glow: 0 },
  eye: { colour: 0x9fe4ff, team: 0, glow: 1 },
  black: { colour: 0x14171a, team: 0, glow: 0 },
};

/**
 * @param {Paint} paint
 * @param {THREE.BufferGeometry} geometry
 * @param {[number, number, number]} [place] where its centre goes
 * @returns {Piece}
 */
export function piece(paint, geometry, place) {
  return { paint, geometry: place ? geometry.translate(...place) : geometry };
}

/**
 * Joins pieces to one geometry with the attributes `color` and `paint` (x = team colour, y = glow).
 *
 * @param {Piece[]} pieces
 * @returns {THREE.BufferGeometry}
 */
export function joined(pieces) {
  const whole = new THREE.BufferGeometry();
  const index = [];
  const position = [];
  const normal = [];
  const color = [];
  const paint = [];
  for (const { geometry, paint: name } of pieces) {
    const { team, glow } = PAINTS[name];
    const colour = new THREE.Color(PAINTS[name].colour);
    const start = position.length / 3;
    const places = geometry.getAttribute('position');
    index.push(...Array.from(indexOf(geometry), (i) => i + start));
    position.push(...places.array);
    normal.push(...geometry.getAttribute('normal').array);
    for (let i = 0; i < places.count; i++) {
      color.push(colour.r, colour.g, colour.b);
      paint.push(team, glow);
    }
    geometry.dispose();
  }
  whole.setIndex(index);
  whole.setAttribute('position', new THREE.Float32BufferAttribute(position, 3));
  whole.setAttribute('normal', new THREE.Float32BufferAttribute(normal, 3));
  whole.setAttribute('color', new THREE.Float32BufferAttribute(color, 3));
  whole.setAttribute('paint', new THREE.Float32BufferAttribute(paint, 2));
  return whole;
}

/** @param {THREE.BufferGeometry} geometry */
function indexOf(geometry) {
  return geometry.index?.array ?? Array.from({ length: geometry.getAttribute('position').count }, (_, i) => i);
}

/**
 * Makes the left limb from the right one.
 *
 * @param {THREE.BufferGeometry} right is changed
 * @returns {THREE.BufferGeometry}
 */
export function mirrored(right) {
  right.scale(-1, 1, 1);
  const index = /** @type {THREE.BufferAttribute} */ (right.index).array;
  for (let i = 0; i < index.length; i += 3) {
    [index[i], index[i + 1]] = [index[i + 1], index[i]];
  }
  return right;
}
