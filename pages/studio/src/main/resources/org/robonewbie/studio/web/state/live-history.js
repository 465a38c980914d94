/** Keeps the state frames from the last ten minutes of the running simulation. */
import { readFrame } from '../live/state-frame.js';
import { partitionPoint } from './partition-point.js';

/**
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../live/state-frame.js').Frame} Frame
 * @typedef {{cycle: number, scene: Scene, bytes: ArrayBuffer}} Kept
 */

/** Maximum number of frames: ten minutes at 25 frames per second; 22 robots need 1.4 KB per frame. */
const MAX_FRAMES = 15_000;

export class LiveHistory {
  constructor() {
    /** @type {Kept[]} */
    this.kept = [];
  }

  clear() {
    this.kept = [];
  }

  /** @param {number} cycle @param {Scene} scene @param {ArrayBuffer} bytes */
  push(cycle, scene, bytes) {
    while ((this.kept.at(-1)?.cycle ?? -1) >= cycle) {
      this.kept.pop();
    }
    this.kept.push({ cycle, scene, bytes });
    if (this.kept.length > MAX_FRAMES * 1.1) {
      this.kept.splice(0, this.kept.length - MAX_FRAMES);
    }
  }

  get first() {
    return this.kept[0]?.cycle ?? 0;
  }

  get last() {
    return this.kept.at(-1)?.cycle ?? 0;
  }

  /** @param {number} cycle @returns {number} index of the last frame that is not later than the cycle; 0 if all frames are later */
  indexOf(cycle) {
    return Math.max(0, partitionPoint(this.kept.length, (i) => this.kept[i].cycle <= cycle) - 1);
  }

  /** @param {number} cycle @returns {{scene: Scene, frame: Frame} | undefined} the state at this cycle */
  at(cycle) {
    return this.read(this.indexOf(cycle));
  }

  /** @param {number} index @returns {{scene: Scene, frame: Frame} | undefined} */
  read(index) {
    const kept = this.kept[index];
    const frame = kept && readFrame(kept.bytes, kept.scene);
    return frame && { scene: kept.scene, frame };
  }
}
