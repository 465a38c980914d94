/** The visible faces of a scene as polygons on the screen, for {@link CanvasRenderer}. */
import * as THREE from 'three';
import { SUN } from './light.js';

/**
 * @typedef {object} Face
 * @property {number} layer ground, solid objects or overlays
 * @property {number} depth within its layer; larger ones are painted first
 * @property {string} style
 * @property {number[]} points x and y of each corner in pixels; for a picture, only its top left and bottom right corners
 * @property {boolean} isLine
 * @property {boolean} [grows] whether it is enlarged to hide the seams between it and its neighbours
 * @property {CanvasImageSource} [picture]
 *
 * @typedef {object} Body poses and colours of a mesh
 * @property {THREE.Matrix4[]} poses one, or one for each limb
 * @property {number[]} [team] red, green and blue of the team
 * @property {number} opacity
 */

const [GROUND, SOLID, OVERLAY] = [0, 1, 2];

/** Faces below this height belong to the ground, over which everything else is painted. */
const GROUND_METRES = 0.015;

/** Distance by which painted parts are brought forward, in front of the shell below them. */
const PAINT_METRES = 0.02;

/** Distance by which one unit of a material's polygon offset moves a face away from the camera. */
const OFFSET_METRES = 0.02;

const TO_SUN = SUN.clone().normalize();
const SKY_LIGHT = 0.45;
const SUN_LIGHT = 0.6;

/** Distance by which faces are enlarged to hide the seams between them. */
const SEAM_PIXELS = 0.6;

export class Faces {
  /** @type {Face[]} */
  #list = [];

  /** @param {THREE.PerspectiveCamera} camera @param {number} width of the picture, pixels @param {number} height */
  constructor(camera, width, height) {
    this.camera = camera;
    this.width = width;
    this.height = height;
  }

  /** All faces in the order in which they must be painted. */
  get sorted() {
    return this.#list.sort((one, other) => one.layer - other.layer || other.depth - one.depth);
  }

  /** @param {THREE.Object3D} object */
  add(object) {
    if (object instanceof THREE.Sprite) {
      this.#addSprite(object);
    } else if (object instanceof THREE.Points) {
      this.#addPoints(object);
    } else if (object instanceof THREE.Line) {
      this.#addLines(object);
    } else if (object instanceof THREE.Mesh && isDrawable(object.material)) {
      bodiesOf(object).forEach((body) => this.#addBody(object, body));
    }
  }

  /** @param {THREE.Mesh} mesh @param {Body} body */
  #addBody({ geometry, material, renderOrder }, body) {
    const look = /** @type {THREE.MeshBasicMaterial} */ (material);
    const { position, limb } = geometry.attributes;
    const order = geometry.index;
    const { start, count } = geometry.drawRange;
    const end = Math.min(start + count, order?.count ?? position?.count ?? 0);
    for (let i = start; i < end; i += 3) {
      const corners = [0, 1, 2].map((k) => order?.getX(i + k) ?? i + k);
      const places = corners.map((corner, k) =>
        scratch[k].fromBufferAttribute(position, corner).applyMatrix4(body.poses[limb?.getX(corner) ?? 0]),
      );
      const [a, b, c] = places;
      const turned = facing.setFromCoplanarPoints(a, b, c).distanceToPoint(this.camera.position);
      if (turned > 0 || look.side === THREE.DoubleSide) {
        const normal = turned > 0 ? facing.normal : facing.normal.negate();
        const paint = geometry.attributes.paint?.getX(corners[0]) ?? 0;
        this.#push(places, {
          ...this.#place(places, look, renderOrder, paint),
          style: styleOf(geometry, look, body, corners[0], normal),
          points: [],
          isLine: false,
          grows: !(look instanceof THREE.MeshBasicMaterial),
        });
      }
    }
  }

  /**
   * @param {THREE.Vector3[]} places corners in the world
   * @param {THREE.Material} look
   * @param {number} renderOrder
   * @param {number} [paint] 1 for painted parts
   */
  #place(places, look, renderOrder, paint = 0) {
    if (!look.depthTest) {
      return { layer: OVERLAY, depth: -renderOrder };
    }
    const top = Math.max(...places.map(({ z }) => z));
    if (top < GROUND_METRES) {
      return { layer: GROUND, depth: -top };
    }
    const middle = centre.set(0, 0, 0);
    places.forEach((place) => middle.addScaledVector(place, 1 / places.length));
    const behind = look.polygonOffset ? OFFSET_METRES * look.polygonOffsetFactor : 0;
    return { layer: SOLID, depth: middle.distanceTo(this.camera.position) + behind - PAINT_METRES * paint };
  }

  /** Clips a polygon or line at the camera's near plane and adds it. @param {THREE.Vector3[]} places @param {Face} face without points */
  #push(places, face) {
    places.forEach((place) => place.applyMatrix4(this.camera.matrixWorldInverse));
    const points = this.#pixels(clipped(places, this.camera.near, face.isLine));
    if (points.length >= (face.isLine ? 4 : 6)) {
      face.points = face.grows ? enlarged(points) : points;
      this.#list.push(face);
    }
  }

  /** @param {THREE.Vector3[]} corners in the camera's frame @returns {number[]} */
  #pixels(corners) {
    const { elements } = this.camera.projectionMatrix;
    const points = [];
    for (const { x, y, z } of corners) {
      points.push((this.width / 2) * (1 - (elements[0] * x) / z - elements[8]));
      points.push((this.height / 2) * (1 + (elements[5] * y) / z + elements[9]));
    }
    return points;
  }

  /** @param {THREE.Line} line */
  #addLines(line) {
    const look = /** @type {THREE.LineBasicMaterial} */ (line.material);
    const { position, color } = line.geometry.attributes;
    const count = position?.count ?? 0;
    const step = line instanceof THREE.LineSegments ? 2 : 1;
    const last = line instanceof THREE.LineLoop ? count : count - 1;
    for (let i = 0; i < last; i += step) {
      const places = [i, (i + 1) % count].map((at, k) =>
        scratch[k].fromBufferAttribute(position, at).applyMatrix4(line.matrixWorld),
      );
      const own = look.vertexColors ? [color.getX(i), color.getY(i), color.getZ(i)] : look.color.toArray();
      const style = rgb(own, look.opacity);
      this.#push(places, { ...this.#place(places, look, line.renderOrder), style, points: [], isLine: true });
    }
  }

  /** @param {THREE.Points} dots */
  #addPoints({ geometry, material, matrixWorld }) {
    const { position, color } = geometry.attributes;
    const half = /** @type {THREE.PointsMaterial} */ (material).size / 2;
    for (let i = 0; i < Math.min(geometry.drawRange.count, position.count); i++) {
      const place = scratch[0].fromBufferAttribute(position, i).applyMatrix4(matrixWorld);
      const depth = place.distanceTo(this.camera.position);
      const [x, y] = this.#pixels(
        clipped([place.applyMatrix4(this.camera.matrixWorldInverse)], this.camera.near, true),
      );
      const style = rgb([color.getX(i), color.getY(i), color.getZ(i)], color.getW(i));
      const points = [x - half, y, x, y - half, x + half, y, x, y + half];
      this.#list.push({ layer: SOLID, depth, style, points, isLine: false });
    }
  }

  /** @param {THREE.Sprite} sprite a label, whose size does not depend on its distance */
  #addSprite({ material, matrixWorld, scale, center, renderOrder }) {
    const place = scratch[0].setFromMatrixPosition(matrixWorld).applyMatrix4(this.camera.matrixWorldInverse);
    const [x, y] = this.#pixels(clipped([place], this.camera.near, true));
    const pixels = (this.camera.projectionMatrix.elements[5] * this.height) / 2;
    const [width, height] = [pixels * scale.x, pixels * scale.y];
    const [left, bottom] = [x - center.x * width, y + center.y * height];
    const points = [left, bottom - height, left + width, bottom];
    const picture = /** @type {HTMLCanvasElement | undefined} */ (material.map?.image);
    if (picture && x !== undefined) {
      this.#list.push({ layer: OVERLAY, depth: -renderOrder, style: '', points, isLine: false, picture });
    }
  }
}

const scratch = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
const centre = new THREE.Vector3();
const facing = new THREE.Plane();

/**
 * @param {THREE.Material | THREE.Material[]} material @returns {boolean} whether it has a plain colour; the sky and textured materials are
 *     omitted
 */
function isDrawable(material) {
  const { side, vertexColors, map } = /** @type {THREE.MeshBasicMaterial} */ (material);
  return side !== THREE.BackSide && !(material instanceof THREE.ShadowMaterial) && (vertexColors || !map);
}

/** @param {THREE.Mesh} mesh @returns {Body[]} */
function bodiesOf(mesh) {
  const { opacity } = /** @type {THREE.Material} */ (mesh.material);
  const { robot, darkness } = mesh.geometry.attributes;
  if (robot) {
    const table = /** @type {import('./robot-table.js').RobotTable} */ (mesh.userData.table);
    const { instanceCount } = /** @type {THREE.InstancedBufferGeometry} */ (mesh.geometry);
    return Array.from({ length: instanceCount }, (_, i) => ({ ...table.robot(robot.getX(i)), opacity }));
  }
  if (mesh instanceof THREE.InstancedMesh) {
    return Array.from({ length: mesh.count }, (_, i) => {
      const pose = new THREE.Matrix4();
      mesh.getMatrixAt(i, pose);
      return { poses: [pose.premultiply(mesh.matrixWorld)], opacity: darkness ? 0.5 * darkness.getX(i) : opacity };
    });
  }
  return [{ poses: [mesh.matrixWorld], opacity }];
}

/**
 * @param {THREE.BufferGeometry} geometry
 * @param {THREE.MeshBasicMaterial} look
 * @param {Body} body
 * @param {number} corner index of the face's first corner
 * @param {THREE.Vector3} normal
 */
function styleOf({ attributes: { color, paint } }, look, { team, opacity }, corner, normal) {
  const own = look.vertexColors ? [color.getX(corner), color.getY(corner), color.getZ(corner)] : look.color?.toArray();
  if (look instanceof THREE.ShaderMaterial) {
    return css(
      (own ?? [0, 0, 0]).map((part) => 255 * part),
      opacity,
    );
  }
  const painted = look.vertexColors ? (paint?.getX(corner) ?? 0) : 1;
  const colour = (own ?? [1, 1, 1]).map((part, i) => part + (team ? painted * (team[i] - part) : 0));
  const isLit = !(look instanceof THREE.MeshBasicMaterial);
  const light = isLit ? SKY_LIGHT * (0.75 + 0.25 * normal.z) + SUN_LIGHT * Math.max(0, normal.dot(TO_SUN)) : 1;
  const glow = paint?.getY(corner) ?? 0;
  return rgb(
    colour.map((part) => part * (light + glow)),
    opacity,
  );
}

/** @param {number[]} linear red, green and blue in linear light @param {number} opacity */
function rgb(linear, opacity) {
  return css(
    linear.map((part) => 255 * Math.min(1, part) ** (1 / 2.2)),
    opacity,
  );
}

/** @param {number[]} colour @param {number} opacity */
function css(colour, opacity) {
  const [red, green, blue, alpha] = [...colour, 255 * opacity].map(Math.round);
  return `#${(((red << 24) | (green << 16) | (blue << 8) | alpha) >>> 0).toString(16).padStart(8, '0')}`;
}

/**
 * Clips a polygon or polyline at the camera's near plane.
 *
 * @param {THREE.Vector3[]} corners in the frame of the camera, which looks along -z
 * @param {number} near
 * @param {boolean} isOpen whether the last corner is not joined to the first
 * @returns {THREE.Vector3[]}
 */
function clipped(corners, near, isOpen) {
  if (corners.every(({ z }) => z < -near)) {
    return corners;
  }
  return corners.flatMap((corner, i) => {
    const next = corners[i + 1] ?? corners[0];
    const isEnd = isOpen && i === corners.length - 1;
    const inside = corner.z < -near ? [corner] : [];
    if (isEnd || corner.z < -near === next.z < -near) {
      return inside;
    }
    const part = (-near - corner.z) / (next.z - corner.z);
    return [...inside, new THREE.Vector3().lerpVectors(corner, next, part)];
  });
}

/** @param {number[]} points @returns {number[]} the polygon, a little larger */
function enlarged(points) {
  const [x, y] = [meanOf(points, 0), meanOf(points, 1)];
  for (let i = 0; i < points.length; i += 2) {
    points[i] += SEAM_PIXELS * Math.sign(points[i] - x);
    points[i + 1] += SEAM_PIXELS * Math.sign(points[i + 1] - y);
  }
  return points;
}

/** @param {number[]} points @param {0 | 1} axis */
function meanOf(points, axis) {
  let sum = 0;
  for (let i = axis; i < points.length; i += 2) {
    sum += points[i];
  }
  return (2 * sum) / points.length;
}
