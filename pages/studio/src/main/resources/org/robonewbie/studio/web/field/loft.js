/** Lofted bodies: a surface through cross-sections along an axis. */
import * as THREE from 'three';

/**
 * @typedef {object} Section one cross-section
 * @property {number} at position on the axis, metres
 * @property {number} wide half width (x), metres
 * @property {number} deep half depth (y; −z if the axis is y), metres
 * @property {number} [x] offset of the centre
 * @property {number} [y] offset of the centre
 *
 * @typedef {object} LoftOptions
 * @property {'z' | 'y' | 'x'} [axis] axis of the loft; default z
 * @property {number} [segments] facets around the axis
 * @property {number} [rings] facets along the axis
 * @property {number} [square] 2 = ellipse, higher values = squarer
 * @property {number} [inflate] offset of the surface, metres
 * @property {[number, number]} [around] range of angles to which the loft is limited: degrees, 0 = front (y), 90 = right (x)
 * @property {[number, number]} [along] range of the axis to which the loft is limited, from 0 to 1
 */

const RADIANS = Math.PI / 180;

/**
 * Builds the surface.
 *
 * @param {Section[]} sections cross-sections in ascending order
 * @param {LoftOptions} [options]
 * @returns {THREE.BufferGeometry} a surface with texture coordinates such that the texture of a patch reads correctly from outside
 */
export function loft(sections, options = {}) {
  const { segments = 20, rings = 12, around, along = [0, 1] } = options;
  const [start, end] = around ?? [0, 360];
  const positions = [];
  const uvs = [];
  for (let ring = 0; ring <= rings; ring++) {
    const v = ring / rings;
    const section = sectionAt(sections, along[0] + v * (along[1] - along[0]));
    for (let segment = 0; segment <= segments; segment++) {
      const u = segment / segments;
      positions.push(...pointOn(section, start + u * (end - start), options));
      uvs.push(1 - u, v);
    }
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  geometry.setAttribute('uv', new THREE.Float32BufferAttribute(uvs, 2));
  geometry.setIndex(gridIndex(rings, segments));
  geometry.computeVertexNormals();
  if (!around) {
    closeSeam(geometry, rings, segments);
  }
  return oriented(geometry, options.axis ?? 'z');
}

/**
 * Interpolates the sections with a Catmull-Rom spline.
 *
 * @param {Section[]} sections
 * @param {number} part position along all sections, from 0 to 1
 * @returns {Required<Section>}
 */
function sectionAt(sections, part) {
  const place = part * (sections.length - 1);
  const index = Math.min(Math.floor(place), sections.length - 2);
  const t = place - index;
  const ribs = [-1, 0, 1, 2].map((step) => sections[Math.max(0, Math.min(sections.length - 1, index + step))]);
  /** @param {'at' | 'wide' | 'deep' | 'x' | 'y'} key */
  const value = (key) => {
    const [a, b, c, d] = ribs.map((rib) => rib[key] ?? 0);
    return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
  };
  return {
    at: value('at'),
    wide: Math.max(0, value('wide')),
    deep: Math.max(0, value('deep')),
    x: value('x'),
    y: value('y'),
  };
}

/**
 * @param {Required<Section>} section
 * @param {number} degrees
 * @param {LoftOptions} options
 */
function pointOn(section, degrees, { square = 2.4, inflate = 0 }) {
  const sine = Math.sin(degrees * RADIANS);
  const cosine = Math.cos(degrees * RADIANS);
  const x = (section.wide + inflate) * Math.sign(sine) * Math.abs(sine) ** (2 / square);
  const y = (section.deep + inflate) * Math.sign(cosine) * Math.abs(cosine) ** (2 / square);
  return [section.x + x, section.y + y, section.at];
}

/**
 * @param {number} rings
 * @param {number} segments
 */
function gridIndex(rings, segments) {
  const index = [];
  for (let ring = 0; ring < rings; ring++) {
    for (let segment = 0; segment < segments; segment++) {
      const a = ring * (segments + 1) + segment;
      const b = a + segments + 1;
      index.push(a, b, a + 1, b, b + 1, a + 1);
    }
  }
  return index;
}

/**
 * Averages the normals along the seam, so that the shading is smooth there.
 *
 * @param {THREE.BufferGeometry} geometry
 * @param {number} rings
 * @param {number} segments
 */
function closeSeam(geometry, rings, segments) {
  const normals = geometry.getAttribute('normal');
  const sum = new THREE.Vector3();
  for (let ring = 0; ring <= rings; ring++) {
    const first = ring * (segments + 1);
    const last = first + segments;
    sum
      .set(
        normals.getX(first) + normals.getX(last),
        normals.getY(first) + normals.getY(last),
        normals.getZ(first) + normals.getZ(last),
      )
      .normalize();
    normals.setXYZ(first, sum.x, sum.y, sum.z);
    normals.setXYZ(last, sum.x, sum.y, sum.z);
  }
}

/**
 * @param {THREE.BufferGeometry} geometry
 * @param {'z' | 'y' | 'x'} axis
 */
function oriented(geometry, axis) {
  if (axis === 'y') {
    geometry.rotateX(-Math.PI / 2);
  } else if (axis === 'x') {
    geometry.rotateY(Math.PI / 2);
  }
  return geometry;
}

/**
 * Builds a cylinder with rounded edges.
 *
 * @param {number} radius
 * @param {number} length
 * @param {LoftOptions} [options] options; with fewer than nine rings the edges are chamfered, with fewer than four they are sharp
 */
export function barrel(radius, length, options = {}) {
  const half = length / 2;
  const round = Math.min(0.3 * radius, 0.3 * length);
  const edge = edgeOf(half, radius, round, options.rings ?? 9);
  const ribs = [...edge.map(([at, r]) => [-at, r]), ...edge.reverse()].map(([at, r]) => ({ at, wide: r, deep: r }));
  return loft(ribs, { square: 2, ...options, rings: ribs.length - 1 });
}

/**
 * @param {number} half half the length
 * @param {number} radius
 * @param {number} round radius of the rounding
 * @param {number} rings number of facets
 * @returns {number[][]} position along the axis and radius, from the centre of the end outwards
 */
function edgeOf(half, radius, round, rings) {
  if (rings < 4) {
    return [
      [half, 0],
      [half, radius],
    ];
  }
  return rings < 9
    ? [
        [half, 0],
        [half, radius - round],
        [half - round, radius],
      ]
    : [
        [half, 0],
        [half, 0.6 * (radius - round)],
        [half, radius - round],
        [half - 0.3 * round, radius - 0.3 * round],
        [half - round, radius],
      ];
}

/**
 * Builds an ellipsoid.
 *
 * @param {number} x half width
 * @param {number} y half depth
 * @param {number} z half height
 * @param {LoftOptions} [options]
 */
export function ellipsoid(x, y, z, options = {}) {
  const rings = options.rings ?? 8;
  const ribs = Array.from({ length: rings + 1 }, (_, i) => {
    const angle = (i / rings - 0.5) * Math.PI;
    const r = Math.max(0, Math.cos(angle));
    return { at: z * Math.sin(angle), wide: x * r, deep: y * r };
  });
  return loft(ribs, { square: 2, ...options, rings });
}

/**
 * Builds a flat ring or disc facing along y.
 *
 * @param {number} inner radius of the hole, 0 for a disc
 * @param {number} outer
 * @param {number} segments number of facets
 */
export function disc(inner, outer, segments) {
  return new THREE.RingGeometry(inner, outer, segments, 1).rotateX(-Math.PI / 2);
}
