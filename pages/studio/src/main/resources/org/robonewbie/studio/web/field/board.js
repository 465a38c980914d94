/** The teams' RoboViz drawings, rendered as one mesh for all shapes and one sprite per label. */
import * as THREE from 'three';
import { boardTriangles } from '../state/board-shapes.js';
import { DrawingGroup, textLook } from './drawings.js';

/** @typedef {import('../state/board-shapes.js').BoardShape} BoardShape */

const METRES_ABOVE_TORSO = 0.45;
const MAX_TEXTS = 200;

export class Board extends DrawingGroup {
  /** Labels that are attached to robots. @type {Array<{sprite: THREE.Sprite, shape: BoardShape}>} */
  #above = [];

  constructor() {
    super('board', { transparent: true, depthWrite: false });
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
    this.fill(places, colours, 4);
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
      const sprite = this.addText(textLook(shape.text, shape.colour), shape.text);
      if (shape.shape === 'agent') {
        this.#above.push({ sprite, shape });
      } else {
        const [x, y, z] = shape.numbers ?? [0, 0, 0];
        sprite.position.set(x, y, z);
      }
    }
  }

  /**
   * Moves the attached labels to their robots.
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
