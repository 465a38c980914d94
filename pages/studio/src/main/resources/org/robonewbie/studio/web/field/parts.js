/** Merges painted pieces into bodies, and bodies into one robot, so that all robots need one draw call. */
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
 * @param {[number, number, number]} [place] position of its centre
 * @returns {Piece}
 */
export function piece(paint, geometry, place) {
  return { paint, geometry: place ? geometry.translate(...place) : geometry };
}

/**
 * Merges pieces into one geometry with the attributes `color` and `paint` (x = team colour, y = glow).
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
    index.push(...trianglesOf(geometry).map((i) => i + start));
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

/** @param {THREE.BufferGeometry} geometry @returns {ArrayLike<number>} */
function indexOf(geometry) {
  return geometry.index?.array ?? Array.from({ length: geometry.getAttribute('position').count }, (_, i) => i);
}

/**
 * Returns the triangles without the degenerate ones, which occur at the ends of bodies.
 *
 * @param {THREE.BufferGeometry} geometry
 * @returns {number[]}
 */
function trianglesOf(geometry) {
  const corners = indexOf(geometry);
  const places = geometry.getAttribute('position');
  const triangles = [];
  for (let i = 0; i < corners.length; i += 3) {
    triangle.setFromAttributeAndIndices(places, corners[i], corners[i + 1], corners[i + 2]);
    if (triangle.getArea() > SMALLEST_SQUARE_METRES) {
      triangles.push(corners[i], corners[i + 1], corners[i + 2]);
    }
  }
  return triangles;
}

const triangle = new THREE.Triangle();
const SMALLEST_SQUARE_METRES = 1e-10;

/**
 * Mirrors a right limb to create the left one.
 *
 * @param {THREE.BufferGeometry} right modified in place
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

/**
 * Merges limbs into one geometry whose attribute `limb` assigns each vertex to its limb.
 *
 * @param {Array<{limb: number, body: THREE.BufferGeometry}>} parts parts with the same attributes
 * @returns {THREE.BufferGeometry}
 */
export function assembled(parts) {
  const whole = new THREE.BufferGeometry();
  const starts = parts.map(({ body }) => body.getAttribute('position').count);
  starts.reduce((sum, count, i) => ((starts[i] = sum), sum + count), 0);
  whole.setIndex(parts.flatMap(({ body }, i) => Array.from(indexOf(body), (corner) => corner + starts[i])));
  for (const [name, { itemSize }] of Object.entries(parts[0].body.attributes)) {
    whole.setAttribute(
      name,
      new THREE.Float32BufferAttribute(
        parts.flatMap(({ body }) => [...body.getAttribute(name).array]),
        itemSize,
      ),
    );
  }
  const limbs = parts.flatMap(({ body, limb }) => new Array(body.getAttribute('position').count).fill(limb));
  whole.setAttribute('limb', new THREE.Float32BufferAttribute(limbs, 1));
  parts.forEach(({ body }) => body.dispose());
  return whole;
}
