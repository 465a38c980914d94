/**
 * Visibility of drawings: all drawings, those of one robot, or one kind of drawing from a robot. A layer is hidden if it or a parent is
 * switched off. Pure.
 */

/** The root layer. */
export const ALL_DRAWINGS = '';

/** Kinds of drawings with their labels, in display order. */
export const KINDS = { circle: 'Circles', line: 'Lines', point: 'Points', text: 'Texts' };

/** @param {string} robot key of the robot @param {string} kind @returns {string} */
export function layerOf(robot, kind) {
  return `${robot}\t${kind}`;
}

export class DrawingLayers {
  /** @param {Iterable<string>} off hidden layers */
  constructor(off = []) {
    this.off = new Set(off);
  }

  /** @param {string} layer */
  isOn(layer) {
    return !this.off.has(layer);
  }

  /** @param {string} layer @param {boolean} on */
  set(layer, on) {
    if (on) {
      this.off.delete(layer);
    } else {
      this.off.add(layer);
    }
  }

  /** @param {string} robot key of the robot @param {string} kind */
  shows(robot, kind) {
    return [ALL_DRAWINGS, robot, layerOf(robot, kind)].every((layer) => this.isOn(layer));
  }
}
