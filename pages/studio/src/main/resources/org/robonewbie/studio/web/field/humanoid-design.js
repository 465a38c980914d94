/**
 * Figure of the league's humanoids, such as the Booster T1 and K1: white shells over dark joints, a dark visor with two lights, parts in
 * the team's colour. Its lengths are those between the robot's joints, so that it fits any robot with the league's motor names.
 */
import * as THREE from 'three';
import { figureOf } from '../state/figure.js';
import { barrel, ellipsoid, loft } from './loft.js';
import { assembled, piece } from './parts.js';

/**
 * @typedef {import('../state/kinematics.js').RobotModel} RobotModel
 * @typedef {import('./parts.js').Piece} Piece
 * @typedef {import('./parts.js').Paint} Paint
 * @typedef {import('./nao-design.js').Facets} Facets
 * @typedef {import('./loft.js').Section} Section
 * @typedef {import('./loft.js').LoftOptions} LoftOptions
 */

/** Size of the drawn head relative to the shape that collides. */
const ROUNDER = 1.12;

const NEEDED = ['he1', 'he2', ...['l', 'r'].flatMap((side) => [1, 2, 3, 4].map((i) => `${side}ae${i}`))].concat(
  ['l', 'r'].flatMap((side) => [1, 2, 3, 4, 5, 6].map((i) => `${side}le${i}`)),
);

/** @param {RobotModel} model @returns {boolean} whether the robot has the motors of a humanoid of the league */
export function isHumanoid({ hinges }) {
  return NEEDED.every((motor) => hinges.some(({ effector }) => effector === motor));
}

/** @param {RobotModel} model @param {Facets} facets @returns {Piece[][]} the pieces of each link */
export function humanoidPieces(model, facets) {
  const body = new Body(model);
  /** @type {Piece[][]} */
  const pieces = model.links.map(() => []);
  const put = (/** @type {string} */ motor, /** @type {Piece[]} */ parts) => pieces[body.link(motor)].push(...parts);
  pieces[0].push(...torso(body, facets));
  put('he1', neck(body, facets));
  put('he2', head(body, facets));
  if (body.has('te1')) {
    put('te1', pelvis(body, facets, 0));
  }
  for (const side of ['l', 'r']) {
    putArm(body, side, facets, put);
    putLeg(body, side, facets, put);
  }
  return pieces;
}

/** @param {RobotModel} model */
export function humanoidPlates(model) {
  const body = new Body(model);
  /** @type {LoftOptions} */
  const patch = { segments: 6, rings: 3, inflate: 0.003 };
  const sections = torsoSections(body);
  const plate = (/** @type {LoftOptions} */ options) => loft(sections, options).translate(0, body.middle, 0);
  return assembled([
    { limb: 0, body: plate({ ...patch, around: [-30, 30], along: [0.44, 0.64] }) },
    { limb: 0, body: plate({ ...patch, around: [146, 214], along: [0.44, 0.68] }) },
  ]);
}

/** Lengths of a robot. */
class Body {
  /** @param {RobotModel} model */
  constructor(model) {
    this.model = model;
    this.size = figureOf(model).height;
    const headShape = this.shapeOf('he2');
    this.headRadius = ROUNDER * (headShape ? headShape.size[2] / 2 : 0.07 * this.size);
    this.headCentre = headShape?.position ?? [0, 0, this.headRadius];
    this.armRadius = this.#radius('lae4', 0.026);
    this.legRadius = this.#radius('lle4', 0.042);
    this.neck = this.position('he1');
    this.shoulder = this.position('lae1');
    this.hip = this.position('lle1');
    /** Forward position of the torso's centre line. */
    this.middle = this.neck[1];
    const box = model.links[0].shapes?.find(({ kind }) => kind === 'box');
    this.depth = box ? box.size[1] / 2 : 0.06 * this.size;
  }

  /** @param {string} motor */
  has(motor) {
    return this.model.hinges.some(({ effector }) => effector === motor);
  }

  /** @param {string} motor @returns {number} index of the link that it moves */
  link(motor) {
    return this.model.hinges.find(({ effector }) => effector === motor)?.child ?? 0;
  }

  /** @param {string} motor @returns {number[]} position of the link that it moves, relative to the torso */
  position(motor) {
    return this.model.links[this.link(motor)].position;
  }

  /** @param {string} motor @param {string} next @returns {number[]} from one joint to the next */
  step(motor, next) {
    return this.position(next).map((value, i) => value - this.position(motor)[i]);
  }

  /** @param {string} motor @returns {import('../state/kinematics.js').Shape | undefined} the last shape of its link */
  shapeOf(motor) {
    return this.model.links[this.link(motor)].shapes?.at(-1);
  }

  /** @param {string} motor @param {number} otherwise fraction of the height */
  #radius(motor, otherwise) {
    const shape = this.shapeOf(motor);
    return shape ? Math.min(...shape.size) / 2 : otherwise * this.size;
  }
}

/** @param {Body} body @returns {Section[]} cross-sections of the torso from waist to neck */
function torsoSections(body) {
  const wide = Math.abs(body.shoulder[0]);
  const low = body.has('te1') ? body.position('te1')[2] : body.hip[2];
  const high = body.neck[2] + 0.25 * body.headRadius - low;
  return [
    [0, 0, 0],
    [0.01, 0.44, 0.55],
    [0.1, 0.6, 0.74],
    [0.3, 0.72, 0.86],
    [0.56, 0.9, 1.02],
    [0.78, 0.98, 1.02],
    [0.93, 0.82, 0.82],
    [1, 0.42, 0.5],
    [1.01, 0, 0],
  ].map(([at, w, d]) => ({ at: low + at * high, wide: w * wide, deep: d * body.depth }));
}

/** @param {Body} body @param {Facets} facets @returns {Piece[]} */
function torso(body, facets) {
  const { body: fine, small, hasDetails } = facets;
  const sections = torsoSections(body);
  const put = (/** @type {LoftOptions} */ options) => loft(sections, options).translate(0, body.middle, 0);
  const band = { ...small, inflate: 0.0025, rings: hasDetails ? 3 : 1 };
  const pieces = [
    piece('shell', put(fine)),
    piece('team', put({ ...band, around: [-64, 64], along: [0.66, 0.76] })),
    piece('team', put({ ...band, around: [116, 244], along: [0.7, 0.77] })),
  ];
  if (hasDetails) {
    pieces.push(
      piece('trim', put({ ...band, inflate: 0.002, around: [66, 114], along: [0.22, 0.6] })),
      piece('trim', put({ ...band, inflate: 0.002, around: [246, 294], along: [0.22, 0.6] })),
    );
  }
  return body.has('te1') ? pieces : [...pieces, ...pelvis(body, facets, body.hip[2])];
}

/** @param {Body} body @param {Facets} facets @param {number} height of its centre @returns {Piece[]} */
function pelvis({ hip, depth, size }, { small, hasDetails }, height) {
  const wide = Math.abs(hip[0]);
  const high = 0.035 * size;
  const rings = Math.max(4, small.rings ?? 0);
  return [
    piece('shell', ellipsoid(0.98 * wide, 0.8 * depth, high, { ...small, rings, square: 2.6 }), [0, 0, height]),
    ...(hasDetails ? [piece('joint', barrel(0.5 * depth, 1.6 * high, small), [0, 0, height + high])] : []),
  ];
}

/** Reaches from the shoulders into the head, however long the neck is. @param {Body} body @param {Facets} facets @returns {Piece[]} */
function neck(body, { small }) {
  const r = body.headRadius;
  const [low, high] = [-0.5 * r, body.step('he1', 'he2')[2] + body.headCentre[2] - 0.6 * r];
  const middle = (low + high) / 2;
  return [piece('joint', barrel(0.45 * r, high - low, small), [0, 0, middle])];
}

/** @param {Body} body @param {Facets} facets @returns {Piece[]} */
function head({ headRadius: r, headCentre: [x, y, z] }, { body, small, hasDetails }) {
  const skull = headSections(r, Math.max(r, z));
  const at = /** @type {[number, number, number]} */ ([x, y, z]);
  const visor = { ...body, inflate: 0.03 * r, rings: hasDetails ? 6 : 2 };
  const eye = (/** @type {number} */ side) =>
    ellipsoid(0.17 * r, 0.1 * r, 0.17 * r, { ...small, rings: Math.max(4, small.rings ?? 0) })
      .rotateZ(-side * 0.3)
      .translate(x + side * 0.38 * r, y + 1.03 * r, z + 0.25 * r);
  const ear = { ...small, axis: /** @type {'x'} */ ('x') };
  return [
    piece('shell', loft(skull, { ...body, square: 2.3 }), at),
    piece('black', loft(skull, { ...visor, around: [-66, 66], along: [0.42, 0.68], square: 2.3 }), at),
    ...(hasDetails ? [piece('eye', eye(1)), piece('eye', eye(-1))] : []),
    piece('team', barrel(0.42 * r, 0.2 * r, ear), [x + 0.95 * r, y, z]),
    piece('team', barrel(0.42 * r, 0.2 * r, ear), [x - 0.95 * r, y, z]),
  ];
}

/** @param {number} r @param {number} chin depth of the chin below the centre @returns {Section[]} */
function headSections(r, chin) {
  const low = chin / r;
  return [
    [-0.98 * low, 0, 0, 0],
    [-0.95 * low, 0.45, 0.45, 0],
    [-0.62 * low, 0.8, 0.82, 0.06],
    [-0.1, 0.97, 1.02, 0.06],
    [0.42, 0.97, 1.02, 0],
    [0.8, 0.76, 0.8, -0.05],
    [1.02, 0.4, 0.42, -0.1],
    [1.06, 0, 0, -0.1],
  ].map(([at, wide, deep, y]) => ({ at: at * r, wide: wide * r, deep: deep * r, y: y * r }));
}

/** @param {Body} body @param {string} side @param {Facets} facets @param {(motor: string, parts: Piece[]) => void} put */
function putArm(body, side, facets, put) {
  const { armRadius: r } = body;
  const { small, hasDetails } = facets;
  const out = side === 'l' ? -1 : 1;
  const upper = body.step(`${side}ae3`, `${side}ae4`);
  const shape = body.shapeOf(`${side}ae4`);
  const reach = shape ? Math.abs(shape.position[0]) + shape.size[2] / 2 : 1.3 * Math.hypot(...upper);
  const along = { ...small, axis: /** @type {'x'} */ ('x') };
  put(`${side}ae1`, [piece('joint', barrel(1.3 * r, 1.7 * r, along), [out * 0.6 * r, 0, 0])]);
  put(`${side}ae2`, [
    piece('shell', ball(1.55 * r, facets)),
    ...(hasDetails ? [piece('team', barrel(1.1 * r, 0.3 * r, along), [out * 1.45 * r, 0, 0])] : []),
  ]);
  put(`${side}ae3`, [
    piece(
      'shell',
      bone(
        upper,
        [1, 1.28, 1.2, 0.9].map((each) => each * r),
        small,
      ),
    ),
    piece(
      'team',
      bone(
        upper,
        [1, 1.28, 1.2, 0.9].map((each) => each * r),
        { ...small, inflate: 0.004, along: [0.5, 0.68] },
      ),
    ),
  ]);
  const fore = [out * (reach - 1.4 * r), 0, 0];
  put(`${side}ae4`, [
    piece('joint', ball(1.05 * r, facets)),
    piece(
      'shell',
      bone(
        fore,
        [0.9, 1.18, 1.05, 0.7].map((each) => each * r),
        small,
      ),
    ),
    piece('trim', ellipsoid(1.5 * r, 0.75 * r, r, { ...small, rings: Math.max(4, small.rings ?? 0) }), [
      out * (reach - 1.1 * r),
      0,
      0,
    ]),
  ]);
}

/** @param {Body} body @param {string} side @param {Facets} facets @param {(motor: string, parts: Piece[]) => void} put */
function putLeg(body, side, facets, put) {
  const { legRadius: r } = body;
  const { small, body: fine, hasDetails } = facets;
  const across = { ...small, axis: /** @type {'x'} */ ('x') };
  const thigh = body.step(`${side}le3`, `${side}le4`);
  const shank = body.step(`${side}le4`, `${side}le5`);
  const rise = body.step(`${side}le2`, `${side}le3`).map((value) => -0.55 * value);
  const calf = [0.75, 1.05, 1, 0.62].map((each) => each * r);
  put(`${side}le1`, [piece('joint', barrel(0.85 * r, 1.5 * r, across))]);
  put(`${side}le2`, [piece('joint', ball(0.95 * r, facets))]);
  put(`${side}le3`, [
    piece(
      'shell',
      bone(
        thigh,
        [0.95, 1.22, 1.12, 0.85].map((each) => each * r),
        fine,
        rise,
      ),
    ),
    piece(
      'team',
      bone(
        thigh,
        [0.95, 1.22, 1.12, 0.85].map((each) => each * r),
        { ...fine, inflate: 0.004, along: [0.4, 0.6] },
        rise,
      ),
    ),
  ]);
  put(`${side}le4`, [
    piece('joint', barrel(0.88 * r, 1.7 * r, across)),
    piece('shell', bone(shank, calf, fine)),
    piece('team', bone(shank, calf, { ...small, inflate: 0.004, around: [-50, 50], along: [0.42, 0.72] })),
  ]);
  put(`${side}le5`, [piece('joint', barrel(0.55 * r, 1.3 * r, across))]);
  put(`${side}le6`, foot(body, side, facets, hasDetails));
}

/** @param {Body} body @param {string} side @param {Facets} facets @param {boolean} hasDetails @returns {Piece[]} */
function foot(body, side, { body: fine, small }, hasDetails) {
  const sole = body.shapeOf(`${side}le6`);
  const [wide, deep, high] = (sole?.size ?? [0.08, 0.18, 0.03]).map((each) => each / 2);
  const [x, y, z] = sole?.position ?? [0, 0, 0];
  const top = Math.max(2 * high, body.legRadius);
  const sections = [
    { at: -high, wide: 0, deep: 0 },
    { at: -high, wide: 0.94 * wide, deep: 0.96 * deep },
    { at: -0.6 * high, wide, deep },
    { at: 0.5 * high, wide: 0.98 * wide, deep: 0.96 * deep, y: -0.02 * deep },
    { at: 0.6 * top, wide: 0.8 * wide, deep: 0.62 * deep, y: -0.2 * deep },
    { at: top, wide: 0.55 * wide, deep: 0.36 * deep, y: -0.22 * deep },
    { at: top, wide: 0, deep: 0, y: -0.22 * deep },
  ];
  const at = /** @type {[number, number, number]} */ ([x, y, z]);
  const options = { ...fine, square: 3 };
  const toe = { ...small, rings: Math.max(4, small.rings ?? 0), square: 2.6 };
  return [
    piece('shell', loft(sections, options), at),
    piece('team', ellipsoid(0.9 * wide, 0.4 * deep, 1.3 * high, toe), [x, y + 0.62 * deep, z + 0.1 * high]),
    ...(hasDetails
      ? [piece('joint', loft(sections, { ...options, inflate: 0.0015, along: [0.17, 0.3], rings: 2 }), at)]
      : []),
  ];
}

/** @param {number} radius @param {Facets} facets */
function ball(radius, { small }) {
  return ellipsoid(radius, radius, radius, { ...small, rings: Math.max(4, small.rings ?? 0) });
}

/**
 * Builds a limb between two joints. Its front is the robot's, unless it points upwards.
 *
 * @param {number[]} to end, relative to the link
 * @param {number[]} radii at the start, at a third, at two thirds, and at the end
 * @param {LoftOptions} options
 * @param {number[]} [from] start
 */
function bone(to, [first, second, third, last], options, from = [0, 0, 0]) {
  const way = new THREE.Vector3(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  const length = way.length();
  const [axis, down] = way.z < 0 ? [DOWN, true] : [UP, false];
  const ribs = [
    [0, 0],
    [0.01, 0.7 * first],
    [0.08, first],
    [0.3, second],
    [0.66, third],
    [0.94, last],
    [1, 0.7 * last],
    [1.01, 0],
  ].map(([at, r]) => ({ at: (down ? -at : at) * length, wide: r, deep: r }));
  const [start, end] = options.along ?? [0, 1];
  return loft(down ? ribs.reverse() : ribs, {
    ...options,
    square: 2.1,
    rings: Math.max(5, options.rings ?? 0),
    along: down ? [1 - end, 1 - start] : [start, end],
  })
    .applyQuaternion(new THREE.Quaternion().setFromUnitVectors(axis, way.normalize()))
    .translate(from[0], from[1], from[2]);
}

const UP = new THREE.Vector3(0, 0, 1);
const DOWN = new THREE.Vector3(0, 0, -1);
