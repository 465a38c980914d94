/**
 * Appearance of robots other than the NAO, in the frames of their links: x to the robot's right, y forward, z up, in metres. A robot with the
 * league's motor names gets the figure of a humanoid; any other is drawn from its shapes.
 */
import * as THREE from 'three';
import { figureOf } from '../state/figure.js';
import { humanoidPieces, humanoidPlates, isHumanoid } from './humanoid-design.js';
import { ellipsoid, loft } from './loft.js';
import { FACETS } from './nao-design.js';
import { assembled, joined, piece } from './parts.js';

/**
 * @typedef {import('../state/kinematics.js').RobotModel} RobotModel
 * @typedef {import('../state/kinematics.js').Shape} Shape
 * @typedef {import('./parts.js').Piece} Piece
 * @typedef {import('./nao-design.js').Facets} Facets
 */

/** Thickness of the struts between the joints of a robot that is drawn from its shapes, as a fraction of its height. */
const STRUT = 0.018;
const SHORTEST_STRUT = 0.01;

/** @param {RobotModel} model @returns {import('./robot-batch.js').Design} */
export function modelDesign(model) {
  const humanoid = isHumanoid(model);
  const pieces = humanoid ? humanoidPieces : shapePieces;
  return {
    limbs: model.links.length,
    body: (detail) => assembled(pieces(model, FACETS[detail]).map((parts, limb) => ({ limb, body: joined(parts) }))),
    plates: () => (humanoid ? humanoidPlates(model) : undefined),
    limbsOf: ({ links }) => links.map((_, limb) => ({ limb, fit: new THREE.Matrix4() })),
  };
}

/** @param {RobotModel} model @param {Facets} facets @returns {Piece[][]} the pieces of each link */
function shapePieces(model, facets) {
  const thickness = STRUT * figureOf(model).height;
  return model.links.map(({ shapes = [] }, link) => [
    ...shapes.map((shape) => piece(link === 0 ? 'team' : 'shell', shapeOf(shape, facets))),
    ...model.hinges
      .filter(({ parent }) => parent === link)
      .map(({ child }) => towards(model, link, child))
      .filter((to) => Math.hypot(...to) > SHORTEST_STRUT)
      .map((to) => piece('joint', strut(to, thickness, facets))),
  ]);
}

/** @param {RobotModel} model @param {number} link @param {number} other @returns {number[]} position of a link relative to another */
export function towards({ links }, link, other) {
  return links[other].position.map((value, i) => value - links[link].position[i]);
}

/** @param {Shape} shape @param {Facets} facets */
function shapeOf({ kind, size: [x, y, z], position, rotation: [w, rx, ry, rz] }, { body, small }) {
  const geometry =
    kind === 'box'
      ? loft(boxSections(x / 2, y / 2, z / 2), { ...small, rings: Math.max(3, small.rings ?? 0), square: 7 })
      : kind === 'sphere'
        ? ellipsoid(x / 2, x / 2, x / 2, body)
        : new THREE.CapsuleGeometry(x / 2, Math.max(0, z - x), 4, body.segments).rotateX(Math.PI / 2);
  return geometry.applyQuaternion(new THREE.Quaternion(rx, ry, rz, w)).translate(position[0], position[1], position[2]);
}

/** @param {number} wide @param {number} deep @param {number} high @returns {import('./loft.js').Section[]} */
function boxSections(wide, deep, high) {
  const edge = Math.min(wide, deep, high) * 0.12;
  return [
    { at: -high, wide: 0, deep: 0 },
    { at: -high, wide: wide - edge, deep: deep - edge },
    { at: -high + edge, wide, deep },
    { at: high - edge, wide, deep },
    { at: high, wide: wide - edge, deep: deep - edge },
    { at: high, wide: 0, deep: 0 },
  ];
}

/** @param {number[]} to @param {number} radius @param {Facets} facets */
function strut(to, radius, { small }) {
  const length = Math.hypot(...to);
  const turn = new THREE.Quaternion().setFromUnitVectors(UP, new THREE.Vector3(to[0], to[1], to[2]).normalize());
  return new THREE.CapsuleGeometry(radius, length, 3, small.segments)
    .rotateX(Math.PI / 2)
    .translate(0, 0, length / 2)
    .applyQuaternion(turn);
}

const UP = new THREE.Vector3(0, 0, 1);
