/** The two goals with their nets. A goal between the camera and the followed robot fades out. */
import * as THREE from 'three';
import { hidesRobot } from '../state/goal-occlusion.js';
import { SUN } from './light.js';

/** @typedef {import('../live/state-frame.js').Field} Field */

const POST_RADIUS = 0.03;
const NET_STEP = 0.1;
const NET_OPACITY = 0.6;

/** Opacity of a faded goal, which remains faintly visible. */
const MIN_OPACITY = 0.06;
const FADE_SECONDS = 0.3;

/** Flattens a goal to its shadow, a little above the lines on the ground. */
const ONTO_GROUND = new THREE.Matrix4().set(
  1,
  0,
  -SUN.x / SUN.z,
  0,
  0,
  1,
  -SUN.y / SUN.z,
  0,
  0,
  0,
  0,
  0.003,
  0,
  0,
  0,
  1,
);
const SHADOW = {
  color: 0x000a06,
  transparent: true,
  depthWrite: false,
  polygonOffset: true,
  polygonOffsetFactor: -3,
  polygonOffsetUnits: -3,
};

export class Goals {
  constructor() {
    this.group = new THREE.Group();
    this.group.name = 'goals';
    /** @type {Goal[]} */
    this.goals = [];
  }

  /** @param {Field} field */
  setField(field) {
    this.goals = [-1, 1].map((end) => new Goal(field, end));
    this.group.clear();
    this.group.add(...this.goals.map(({ group }) => group));
  }

  /** @param {boolean} real whether the sun casts shadows; otherwise flattened goals are drawn */
  setShadows(real) {
    this.goals.forEach(({ shadow }) => {
      shadow.visible = !real;
    });
  }

  /**
   * Fades goals out and in.
   *
   * @param {import('../state/view-point.js').ViewPoint | undefined} view the view of a robot that must not be hidden by a goal
   * @param {number} seconds since the last call
   * @returns {boolean} whether a goal is still fading
   */
  fade(view, seconds) {
    return this.goals.map((goal) => goal.fade(view, seconds)).includes(true);
  }
}

class Goal {
  /** @param {Field} field @param {number} end -1 for the left goal, 1 for the right goal */
  constructor(field, end) {
    this.field = field;
    this.end = end;
    this.opacity = 1;
    const bars = new THREE.MeshLambertMaterial({ color: 0xfafcfd, emissive: 0x3c4044, transparent: true });
    const threads = new THREE.LineBasicMaterial({ color: 0xffffff, transparent: true, opacity: NET_OPACITY });
    const darkBars = new THREE.MeshBasicMaterial({ ...SHADOW, opacity: 0.3 });
    const darkThreads = new THREE.LineBasicMaterial({ ...SHADOW, opacity: 0.12 });
    /** Materials with their opacities in a goal that is not faded. @type {Array<[THREE.Material, number]>} */
    this.looks = [bars, threads, darkBars, darkThreads].map((look) => [look, look.opacity]);
    this.shadow = new THREE.Group();
    this.shadow.add(frame(field, end, darkBars), net(field, end, darkThreads));
    this.shadow.matrixAutoUpdate = false;
    this.shadow.matrix.copy(ONTO_GROUND);
    this.group = new THREE.Group();
    this.group.add(frame(field, end, bars), net(field, end, threads), this.shadow);
  }

  /** @param {import('../state/view-point.js').ViewPoint | undefined} view @param {number} seconds */
  fade(view, seconds) {
    const wanted = view && hidesRobot(this.field, this.end, view) ? MIN_OPACITY : 1;
    const step = seconds / FADE_SECONDS;
    this.opacity += Math.max(-step, Math.min(step, wanted - this.opacity));
    this.looks.forEach(([look, opacity]) => {
      look.opacity = opacity * this.opacity;
    });
    return this.opacity !== wanted;
  }
}

/**
 * @param {Field} field
 * @param {number} end
 * @param {THREE.Material} material
 */
function frame(field, end, material) {
  const places = framePlaces(field, end);
  const bars = new THREE.InstancedMesh(
    new THREE.CylinderGeometry(POST_RADIUS, POST_RADIUS, 1, 14),
    material,
    places.length,
  );
  places.forEach((place, i) => bars.setMatrixAt(i, place));
  bars.castShadow = true;
  bars.frustumCulled = false;
  return bars;
}

/**
 * @param {Field} field
 * @param {number} end
 * @param {THREE.Material} material
 */
function net(field, end, material) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(netPlaces(field, end), 3));
  return new THREE.LineSegments(geometry, material);
}

/**
 * @param {Field} field
 * @param {number} end
 */
function framePlaces(field, end) {
  const front = end * (field.length / 2 + POST_RADIUS);
  const back = front + end * field.goalDepth;
  const side = field.goalWidth / 2 + POST_RADIUS;
  const top = field.goalHeight;
  const low = 0.02;
  return [
    bar([front, -side, 0], [front, -side, top], 1),
    bar([front, side, 0], [front, side, top], 1),
    bar([front, -side - POST_RADIUS, top], [front, side + POST_RADIUS, top], 1),
    bar([back, -side, low], [back, side, low], 0.5),
    bar([front, -side, low], [back, -side, low], 0.5),
    bar([front, side, low], [back, side, low], 0.5),
    bar([front, -side, top], [back, -side, low], 0.4),
    bar([front, side, top], [back, side, low], 0.4),
  ];
}

/**
 * @param {number[]} from
 * @param {number[]} to
 * @param {number} thickness
 */
function bar(from, to, thickness) {
  const start = new THREE.Vector3(...from);
  const way = new THREE.Vector3(...to).sub(start);
  const length = way.length();
  const rotation = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 1, 0), way.clone().normalize());
  const middle = start.addScaledVector(way, 0.5);
  return new THREE.Matrix4().compose(middle, rotation, new THREE.Vector3(thickness, length, thickness));
}

/**
 * Builds the net, which slopes from the crossbar to the ground behind the goal and closes both sides.
 *
 * @param {Field} field
 * @param {number} end
 * @returns {number[]} pairs of points
 */
function netPlaces(field, end) {
  const front = end * (field.length / 2 + POST_RADIUS);
  const back = front + end * field.goalDepth;
  const side = field.goalWidth / 2 + POST_RADIUS;
  const points = [];
  const columns = Math.round((2 * side) / NET_STEP);
  for (let i = 0; i <= columns; i++) {
    const y = -side + (2 * side * i) / columns;
    points.push(front, y, field.goalHeight, back, y, 0);
  }
  const rows = Math.round(field.goalHeight / NET_STEP);
  for (let i = 0; i <= rows; i++) {
    const z = (field.goalHeight * i) / rows;
    const x = back + ((front - back) * i) / rows;
    points.push(x, -side, z, x, side, z);
    points.push(front, -side, z, x, -side, z, front, side, z, x, side, z);
  }
  const deep = Math.max(2, Math.round(field.goalDepth / NET_STEP));
  for (let i = 1; i < deep; i++) {
    const x = front + ((back - front) * i) / deep;
    const z = field.goalHeight * (1 - i / deep);
    points.push(x, -side, 0, x, -side, z, x, side, 0, x, side, z);
  }
  return points;
}
