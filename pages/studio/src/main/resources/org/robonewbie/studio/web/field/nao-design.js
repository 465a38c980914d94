/**
 * Appearance of the NAO: white shells over dark joints, round eyes, parts in the team's colour. Each limb is designed in the frame of the
 * simulated robot's link: x to the robot's right, y forward, z up, in metres. Only right limbs are designed; left ones are mirror images.
 */
import * as THREE from 'three';
import { limbFit } from '../state/limb-fit.js';
import { barrel, disc, ellipsoid, loft } from './loft.js';
import { FOOT, FOREARM, HAND, HEAD, SHANK, SOLE, THIGH, TORSO, UPPER_ARM } from './nao-shells.js';
import { assembled, joined, mirrored, piece } from './parts.js';

/**
 * @typedef {import('three').BufferGeometry} BufferGeometry
 * @typedef {import('./parts.js').Piece} Piece
 * @typedef {import('./loft.js').LoftOptions} LoftOptions
 */

/**
 * Number of facets of bodies and small parts.
 *
 * @typedef {object} Facets
 * @property {LoftOptions} body
 * @property {LoftOptions} small
 * @property {number} disc
 * @property {boolean} hasDetails whether to draw parts that are invisible from a distance
 */

/** Levels of detail: near, at middle distance, far away. @type {Record<'fine' | 'coarse' | 'tiny', Facets>} */
export const FACETS = {
  fine: { body: { segments: 24, rings: 14 }, small: { segments: 18, rings: 9 }, disc: 24, hasDetails: true },
  coarse: { body: { segments: 10, rings: 7 }, small: { segments: 8, rings: 4 }, disc: 10, hasDetails: true },
  tiny: { body: { segments: 5, rings: 4 }, small: { segments: 4, rings: 2 }, disc: 4, hasDetails: false },
};

/** @typedef {keyof typeof FACETS} Detail */

const SIDED = ['shoulder', 'upperarm', 'elbow', 'lowerarm', 'hip1', 'hip2', 'thigh', 'shank', 'ankle', 'foot', 'toe'];

/** All kinds of limbs by the names of their links; the index is the vertex attribute `limb`. */
export const LIMBS = ['body', 'neck', 'head', ...SIDED.flatMap((name) => [`r${name}`, `l${name}`])];

/**
 * Builds one robot: the geometries of all links merged, each vertex in the frame of its link.
 *
 * @param {Detail} detail
 * @returns {BufferGeometry} a geometry with the attribute `limb`
 */
export function naoBody(detail) {
  const facets = FACETS[detail];
  const { small } = facets;
  const bodies = new Map([
    ['body', joined(torso(facets))],
    ['neck', joined(facets.hasDetails ? [piece('joint', barrel(0.024, 0.08, small), [0, 0, 0.01])] : [])],
    ['head', joined(head(facets))],
  ]);
  /** @type {Record<string, () => Piece[]>} */
  const limbs = {
    shoulder: () => shoulder(facets),
    upperarm: () => upperArm(facets),
    elbow: () => [piece('joint', ellipsoid(0.022, 0.022, 0.022, { ...small, rings: Math.max(3, small.rings ?? 0) }))],
    lowerarm: () => lowerArm(facets),
    hip1: () => [piece('joint', ellipsoid(0.03, 0.03, 0.03, { ...small, rings: Math.max(3, small.rings ?? 0) }))],
    hip2: () => (facets.hasDetails ? [piece('joint', barrel(0.024, 0.062, { ...small, axis: 'y' }))] : []),
    thigh: () => thigh(facets),
    shank: () => shank(facets),
    ankle: () => ankle(facets),
    foot: () => foot(facets),
    toe: () => [
      piece('trim', loft(boxRibs(0.043, 0.018, 0.005), { ...small, rings: facets.hasDetails ? 5 : 3, square: 5 })),
    ],
  };
  for (const name of SIDED) {
    bodies.set(`r${name}`, joined(limbs[name]()));
    bodies.set(`l${name}`, mirrored(joined(limbs[name]())));
  }
  return assembled(LIMBS.map((name, limb) => ({ limb, body: /** @type {BufferGeometry} */ (bodies.get(name)) })));
}

/**
 * Builds the number plates on chest and back: two patches of the torso's surface.
 *
 * @returns {BufferGeometry} a geometry with the attribute `limb`
 */
export function numberPlates() {
  /** @type {LoftOptions} */
  const patch = { segments: 6, rings: 3, inflate: 0.0016 };
  return assembled([
    { limb: LIMBS.indexOf('body'), body: loft(TORSO, { ...patch, around: [-27, 27], along: [0.5, 0.71] }) },
    { limb: LIMBS.indexOf('body'), body: loft(TORSO, { ...patch, around: [146, 214], along: [0.44, 0.71] }) },
  ]);
}

/** @type {import('./robot-batch.js').Design} */
export const NAO_DESIGN = {
  limbs: LIMBS.length,
  body: naoBody,
  plates: numberPlates,
  limbsOf: (model) => model.links.map(({ name }, link) => ({ limb: LIMBS.indexOf(name), fit: fitMatrix(model, link) })),
};

/**
 * @param {import('../state/kinematics.js').RobotModel} model
 * @param {number} link
 */
function fitMatrix(model, link) {
  const { scale, offset } = limbFit(model, link);
  return new THREE.Matrix4().makeScale(scale[0], scale[1], scale[2]).setPosition(offset[0], offset[1], offset[2]);
}

/** @param {Facets} facets */
function torso({ body, small, disc: round, hasDetails }) {
  const band = { ...small, inflate: 0.0016, rings: hasDetails ? 3 : 1 };
  const onlyNear = () => [
    piece('trim', loft(TORSO, { ...band, inflate: 0.0012, around: [70, 110], along: [0.2, 0.58] })),
    piece('trim', loft(TORSO, { ...band, inflate: 0.0012, around: [250, 290], along: [0.2, 0.58] })),
    piece('trim', disc(0.0075, 0.0125, round), [0, 0.0588, -0.004]),
    piece('eye', disc(0, 0.0075, round), [0, 0.0588, -0.004]),
    piece('joint', barrel(0.03, 0.16, { ...small, axis: 'x' }), [0, 0, 0.075]),
  ];
  return [
    piece('shell', loft(TORSO, body)),
    piece('team', loft(TORSO, { ...band, around: [-62, 62], along: [0.735, 0.8] })),
    piece('team', loft(TORSO, { ...band, around: [118, 242], along: [0.75, 0.8] })),
    piece(
      'joint',
      loft(boxRibs(0.05, 0.036, 0.022), { ...small, rings: hasDetails ? 5 : 3, square: 3 }),
      [0, -0.004, -0.11],
    ),
    ...(hasDetails ? onlyNear() : []),
  ];
}

/** @param {Facets} facets */
function head(facets) {
  const { body, small, disc: round, hasDetails } = facets;
  const ear = { ...small, axis: /** @type {'x'} */ ('x') };
  const onlyNear = () => [
    piece('black', disc(0, 0.006, round).rotateX(0.55), [0, 0.0575, 0.038]),
    piece('black', disc(0, 0.0055, round).rotateX(-0.35), [0, 0.0622, -0.02]),
    piece('trim', disc(0, 0.02, round).rotateZ(-Math.PI / 2), [0.0705, -0.006, 0.008]),
    piece('trim', disc(0, 0.02, round).rotateZ(Math.PI / 2), [-0.0705, -0.006, 0.008]),
  ];
  return [
    piece('shell', loft(HEAD, { ...body, square: 2.3 })),
    ...eye(1, facets),
    ...eye(-1, facets),
    piece('team', barrel(0.031, 0.016, ear), [0.062, -0.006, 0.008]),
    piece('team', barrel(0.031, 0.016, ear), [-0.062, -0.006, 0.008]),
    ...(hasDetails ? onlyNear() : []),
  ];
}

/**
 * Builds an eye: a black rim that protrudes from the head, and a ring of light inside it.
 *
 * @param {1 | -1} side
 * @param {Facets} facets
 */
function eye(side, { small, disc: round, hasDetails }) {
  /** @param {BufferGeometry} geometry @param {number} off */
  const placed = (geometry, off) =>
    geometry
      .translate(0, off, 0)
      .rotateX(0.06)
      .rotateZ(-side * 0.42)
      .translate(side * 0.0285, 0.0545, 0.009);
  return [
    piece('black', placed(barrel(0.0192, 0.02, { ...small, axis: 'y' }), 0)),
    ...(hasDetails ? [piece('eye', placed(disc(0.0072, 0.0145, round), 0.0103))] : []),
    ...(hasDetails ? [piece('black', placed(disc(0, 0.0072, round), 0.0103))] : []),
  ];
}

/** @param {Facets} facets */
function shoulder({ small, hasDetails }) {
  const along = { ...small, axis: /** @type {'x'} */ ('x') };
  return [
    piece(hasDetails ? 'shell' : 'team', barrel(0.037, 0.05, along), [0.004, 0, 0]),
    ...(hasDetails ? [piece('team', barrel(0.03, 0.012, along), [0.027, 0, 0])] : []),
  ];
}

/** Number of rings of an arm's shells, by the number of rings of small parts. @type {Record<number, number>} */
const RIBS_OF_ARM = { 9: 10, 4: 5, 2: 4 };

/** @param {Facets} facets */
function upperArm({ small }) {
  const along = { ...small, axis: /** @type {'y'} */ ('y') };
  return [
    piece('shell', loft(UPPER_ARM, { ...along, rings: RIBS_OF_ARM[small.rings ?? 9] })),
    piece('team', loft(UPPER_ARM, { ...along, inflate: 0.0015, around: [35, 145], along: [0.42, 0.8] })),
  ];
}

/** @param {Facets} facets */
function lowerArm({ small, hasDetails }) {
  const along = { ...small, axis: /** @type {'y'} */ ('y') };
  const finger = () => barrel(0.0055, 0.03, { segments: 6, rings: 5, axis: 'y' });
  const fingers = () => [
    piece('joint', finger(), [0, 0.072, 0.012]),
    piece('joint', finger(), [0, 0.074, -0.001]),
    piece('joint', finger(), [0, 0.072, -0.014]),
    piece('joint', finger().rotateZ(0.5), [-0.014, 0.057, 0.008]),
  ];
  return [
    piece('shell', loft(FOREARM, { ...along, rings: RIBS_OF_ARM[small.rings ?? 9] })),
    piece('team', loft(FOREARM, { ...along, inflate: 0.0015, along: [0.56, 0.76], rings: hasDetails ? 3 : 1 })),
    piece('trim', loft(HAND, { ...along, rings: hasDetails ? Math.max(3, small.rings ?? 0) : 2 })),
    ...(hasDetails ? fingers() : []),
  ];
}

/** @param {Facets} facets */
function thigh({ body, small }) {
  return [
    piece('shell', loft(THIGH, body)),
    piece('team', loft(THIGH, { ...small, inflate: 0.0016, around: [42, 138], along: [0.3, 0.66] })),
    piece('joint', barrel(0.026, 0.064, { ...small, axis: 'x' }), [0, -0.005, -0.08]),
  ];
}

/** @param {Facets} facets */
function shank({ body, small }) {
  return [
    piece('shell', loft(SHANK, body)),
    piece('team', loft(SHANK, { ...small, inflate: 0.0016, around: [-52, 52], along: [0.36, 0.76] })),
  ];
}

/** @param {Facets} facets */
function ankle({ small, hasDetails }) {
  return [
    piece('joint', barrel(0.022, 0.056, { ...small, axis: 'x' })),
    ...(hasDetails ? [piece('joint', barrel(0.02, 0.058, { ...small, axis: 'y' }), [0, 0, -0.004])] : []),
  ];
}

/** @param {Facets} facets */
function foot({ body, small, hasDetails }) {
  return [
    piece('shell', loft(FOOT, { ...body, square: 2.8 })),
    ...(hasDetails ? [piece('joint', loft(SOLE, { ...body, square: 2.9, rings: 3 }))] : []),
    piece('team', loft(FOOT, { ...small, square: 2.8, inflate: 0.0014, around: [-58, 58], along: [0.1, 0.5] })),
  ];
}

/**
 * @param {number} wide
 * @param {number} deep
 * @param {number} high
 * @returns {import('./loft.js').Section[]}
 */
function boxRibs(wide, deep, high) {
  return [
    { at: -high, wide: 0, deep: 0 },
    { at: -high, wide: 0.85 * wide, deep: 0.85 * deep },
    { at: -0.7 * high, wide, deep },
    { at: 0.7 * high, wide, deep },
    { at: high, wide: 0.85 * wide, deep: 0.85 * deep },
    { at: high, wide: 0, deep: 0 },
  ];
}
