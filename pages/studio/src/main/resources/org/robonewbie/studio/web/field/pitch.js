/**
 * The pitch: striped grass and white lines; all sizes come from the simulator. The ground is flat and evenly lit, so it uses
 * cheap unlit colours; real shadows fall on a transparent plane above it.
 */
import * as THREE from 'three';
import { raised, ring } from '../state/drawing-shapes.js';
import { flatMaterial, hazeMetres, screenColour, tinted } from './flat-material.js';

/**
 * @typedef {import('../live/state-frame.js').Field} Field
 * @typedef {import('../live/state-frame.js').Details} Details
 */

const MIN_LINE_WIDTH = 0.05;

/** Length of the pitch in line widths; the league of 2026 has lines of 10 cm on 55 m. */
const LENGTH_IN_LINES = 550;
const BORDER = 1;
const GROUND_METRES = 300;
const STRIPES = 12;
const OVER_GRASS = 0.002;
const BLADES_METRES = 0.9;

/**
 * @param {{field: Field, details?: Details}} scene
 * @param {import('./light.js').Palette} colours
 * @param {boolean} blades whether the grass has a texture
 * @returns {THREE.Group}
 */
export function pitch({ field, details }, colours, blades) {
  const group = new THREE.Group();
  group.add(
    surround(field, colours),
    grass(field, colours, blades),
    lines(linePlaces(field, details), colours.line),
    shadowSheet(field),
  );
  return group;
}

/**
 * Creates the ground around the grass. It does not extend below the grass, because it would shine through: without a graphics card, the
 * depth of such large triangles is inaccurate.
 *
 * @param {Field} field
 * @param {import('./light.js').Palette} colours
 */
function surround(field, colours) {
  const [far, x, y] = [GROUND_METRES / 2, field.length / 2 + BORDER, field.width / 2 + BORDER];
  const places = [
    ...rectangle(-far, -far, far, -y),
    ...rectangle(-far, y, far, far),
    ...rectangle(-far, -y, -x, y),
    ...rectangle(x, -y, far, y),
  ];
  const haze = { colour: colours.plain, metres: hazeMetres(field) };
  return new THREE.Mesh(tinted(flat(places), colours.surround), flatMaterial(haze));
}

/**
 * @param {Field} field
 * @param {import('./light.js').Palette} colours
 * @param {boolean} blades
 */
function grass(field, colours, blades) {
  const step = field.length / STRIPES;
  const places = [];
  const tints = [];
  for (let i = -1; i <= STRIPES; i++) {
    const left = i < 0 ? -field.length / 2 - BORDER : -field.length / 2 + i * step;
    const right = i === STRIPES ? field.length / 2 + BORDER : -field.length / 2 + (i + 1) * step;
    places.push(...rectangle(left, -field.width / 2 - BORDER, right, field.width / 2 + BORDER));
    const hex = i % 2 === 0 ? colours.grass : colours.grassStripe;
    const colour = blades ? new THREE.Color(hex) : screenColour(hex);
    for (let corner = 0; corner < 6; corner++) {
      tints.push(colour.r, colour.g, colour.b);
    }
  }
  const geometry = flat(places);
  geometry.setAttribute('color', new THREE.Float32BufferAttribute(tints, 3));
  const corners = places.filter((_, i) => i % 3 < 2).map((value) => value / BLADES_METRES);
  geometry.setAttribute('uv', new THREE.Float32BufferAttribute(corners, 2));
  const material = blades ? new THREE.MeshBasicMaterial({ vertexColors: true, map: grain() }) : flatMaterial();
  const mesh = new THREE.Mesh(geometry, material);
  mesh.name = 'grass';
  return mesh;
}

/** Creates a deterministic texture of short blades of grass in slightly different greys. */
function grain() {
  const size = 256;
  const canvas = document.createElement('canvas');
  canvas.width = size;
  canvas.height = size;
  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  pen.fillStyle = '#f1f1f1';
  pen.fillRect(0, 0, size, size);
  let random = 7;
  const next = () => (random = (random * 16807) % 2147483647) / 2147483647;
  for (let i = 0; i < 5200; i++) {
    const grey = 205 + Math.floor(50 * next());
    pen.fillStyle = `rgb(${grey}, ${grey}, ${grey - 8})`;
    pen.fillRect(size * next(), size * next(), 1.5, 2 + 5 * next());
  }
  const texture = new THREE.CanvasTexture(canvas);
  texture.wrapS = THREE.RepeatWrapping;
  texture.wrapT = THREE.RepeatWrapping;
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.anisotropy = 8;
  return texture;
}

/**
 * @param {number[]} places
 * @param {number} colour
 */
function lines(places, colour) {
  const mesh = new THREE.Mesh(
    flat(places),
    new THREE.MeshBasicMaterial({
      color: colour,
      polygonOffset: true,
      polygonOffsetFactor: -2,
      polygonOffsetUnits: -2,
    }),
  );
  mesh.position.z = OVER_GRASS;
  return mesh;
}

/** @param {Field} field */
function shadowSheet(field) {
  const metres = Math.max(60, field.length + 10);
  const sheet = new THREE.Mesh(new THREE.PlaneGeometry(metres, metres), new THREE.ShadowMaterial({ opacity: 0.42 }));
  sheet.position.z = 2 * OVER_GRASS;
  sheet.receiveShadow = true;
  sheet.name = 'shadow-sheet';
  return sheet;
}

/**
 * Returns all lines as triangles on the ground.
 *
 * @param {Field} field
 * @param {Details} [details]
 * @returns {number[]} x, y, z of each vertex
 */
export function linePlaces(field, details) {
  const { length, width, penaltyLength, centreCircleRadius: radius } = field;
  const penaltyWidth = field.goalWidth + field.penaltyWidth;
  const line = lineWidth(field);
  return [
    ...frame(-length / 2, -width / 2, length / 2, width / 2, line),
    ...rectangle(-line / 2, -width / 2, line / 2, width / 2),
    ...raised(ring([0, 0], radius - line / 2, radius + line / 2, 64), 0),
    ...raised(ring([0, 0], 0, 1.6 * line, 16), 0),
    ...frame(-length / 2, -penaltyWidth / 2, -length / 2 + penaltyLength, penaltyWidth / 2, line),
    ...frame(length / 2 - penaltyLength, -penaltyWidth / 2, length / 2, penaltyWidth / 2, line),
    ...(details ? goalAreas(field, details) : []),
  ];
}

/** @param {Field} field */
function lineWidth({ length }) {
  return Math.max(MIN_LINE_WIDTH, length / LENGTH_IN_LINES);
}

/** @param {Field} field @param {Details} details @returns {number[]} goal areas and penalty spots */
function goalAreas(field, { goalAreaLength, goalAreaWidth, penaltySpotDistance }) {
  const { length } = field;
  const width = lineWidth(field);
  return [-1, 1].flatMap((end) => {
    const [line, front] = [(end * length) / 2, end * (length / 2 - goalAreaLength)];
    const [left, right] = [Math.min(line, front), Math.max(line, front)];
    const spot = ring([end * (length / 2 - penaltySpotDistance), 0], 0, 1.6 * width, 16);
    return [
      ...(goalAreaLength > 0 ? frame(left, -goalAreaWidth / 2, right, goalAreaWidth / 2, width) : []),
      ...(penaltySpotDistance > 0 ? raised(spot, 0) : []),
    ];
  });
}

/**
 * @param {number} left
 * @param {number} low
 * @param {number} right
 * @param {number} high
 * @param {number} line width of the lines
 */
function frame(left, low, right, high, line) {
  const half = line / 2;
  return [
    ...rectangle(left - half, low - half, right + half, low + half),
    ...rectangle(left - half, high - half, right + half, high + half),
    ...rectangle(left - half, low, left + half, high),
    ...rectangle(right - half, low, right + half, high),
  ];
}

/**
 * @param {number} left
 * @param {number} low
 * @param {number} right
 * @param {number} high
 */
function rectangle(left, low, right, high) {
  return [left, low, 0, right, low, 0, right, high, 0, left, low, 0, right, high, 0, left, high, 0];
}

/** @param {number[]} places */
function flat(places) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(places, 3));
  const normals = places.map((_, i) => (i % 3 === 2 ? 1 : 0));
  geometry.setAttribute('normal', new THREE.Float32BufferAttribute(normals, 3));
  return geometry;
}
