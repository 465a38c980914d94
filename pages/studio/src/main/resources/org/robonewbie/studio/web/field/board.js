/** RoboViz drawings of the teams, rendered as one mesh for all shapes and one sprite per text. */
import * as THREE from 'three';
import { boardTriangles } from '../state/board-shapes.js';
import { textLook } from './drawings.js';

/** @typedef {import('../state/board-shapes.js').BoardShape} BoardShape */

const TEXT_SCALE = 0.021;
const METRES_ABOVE_TORSO = 0.45;
const MAX_TEXTS = 200;

export class Board {
  /** Texts that are attached to robots. @type {Array<{sprite: THREE.Sprite, shape: BoardShape}>} */
  #above = [];

  constructor() {
    const look = {
      vertexColors: true,
      transparent: true,
      side: THREE.DoubleSide,
      depthWrite: false,
      toneMapped: false,
    };
    this.shapes = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial(look));
    this.shapes.frustumCulled = false;
    this.texts = new THREE.Group();
    this.group = new THREE.Group();
    this.group.name = 'board';
    this.group.add(this.shapes, this.texts);
  }

  /** @param {readonly BoardShape[]} drawn all visible shapes */
  show(drawn) {
    /** @type {number[]} */
    const places = [];
    /** @type {number[]} */
    const colours = [];
    for (const shape of drawn) {
      const corners = boardTriangles(shape);
      const paint = [...new THREE.Color(shape.colour).toArray(), shape.opacity ?? 1];
      corners.forEach((value, i) => {
        places.push(value);
        if (i % 3 === 2) {
          colours.push(...paint);
        }
      });
    }
    this.shapes.geometry.dispose();
    this.shapes.geometry = new THREE.BufferGeometry();
    this.shapes.geometry.setAttribute('position', new THREE.Float32BufferAttribute(places, 3));
    this.shapes.geometry.setAttribute('color', new THREE.Float32BufferAttribute(colours, 4));
    this.shapes.visible = places.length > 0;
    this.#write(drawn.filter(({ text }) => text !== '').slice(0, MAX_TEXTS));
  }

  /** @param {readonly BoardShape[]} texts */
  #write(texts) {
    for (const sprite of /** @type {THREE.Sprite[]} */ (this.texts.children)) {
      sprite.material.map?.dispose();
      sprite.material.dispose();
    }
    this.texts.clear();
    this.#above = [];
    for (const shape of texts) {
      const look = textLook(shape.text, shape.colour);
      const sprite = new THREE.Sprite(look);
      sprite.scale.set(TEXT_SCALE * look.userData.aspect, TEXT_SCALE, 1);
      sprite.center.set(0.5, 0);
      sprite.name = shape.text;
      this.texts.add(sprite);
      if (shape.shape === 'agent') {
        this.#above.push({ sprite, shape });
      } else {
        const [x, y, z] = shape.numbers ?? [0, 0, 0];
        sprite.position.set(x, y, z);
      }
    }
  }

  /**
   * Moves the attached texts to their robots.
   *
   * @param {readonly Float32Array[]} poses
   * @param {readonly import('../live/state-frame.js').Player[]} players
   */
  follow(poses, players) {
    for (const { sprite, shape } of this.#above) {
      const pose = poses[players.findIndex(({ side, number }) => side === shape.side && number === shape.number)];
      sprite.visible = pose !== undefined;
      if (pose) {
        sprite.position.set(pose[0], pose[1], pose[2] + METRES_ABOVE_TORSO);
      }
    }
  }
}
