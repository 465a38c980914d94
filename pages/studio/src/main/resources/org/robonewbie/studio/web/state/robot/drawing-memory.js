/** What all robots have drawn over time, so that each moment of the last minute can be looked at again. Pure. */
import { DRAWING_SECONDS, keep, latest } from './robot-memory.js';
import { readTelemetry } from './telemetry.js';

/** A minute of a robot that draws in each picture of the live view. */
const MOST_PICTURES = 1500;

export class DrawingMemory {
  /** @param {number} [most] how many pictures of each robot are kept */
  constructor(most = MOST_PICTURES) {
    this.most = most;
    /** Lines are kept as they came, since few of them are ever drawn. @type {Map<string, Array<{seconds: number, line: string}>>} */
    this.pictures = new Map();
    /** @type {Map<string, Set<string>>} the kinds of drawings that each robot has made */
    this.kinds = new Map();
  }

  /** @param {readonly string[]} lines of telemetry; what is no picture is left out */
  hear(lines) {
    for (const line of lines.filter((each) => each.startsWith('draw\t'))) {
      const told = readTelemetry(line);
      if (told.kind === 'draw') {
        this.#keep(told.robot, told.seconds, line);
        const kinds = this.kinds.get(told.robot) ?? new Set();
        told.drawings.forEach(({ shape }) => kinds.add(shape));
        this.kinds.set(told.robot, kinds);
      }
    }
  }

  /** A picture from before the last one begins a new time. @param {string} robot @param {number} seconds @param {string} line */
  #keep(robot, seconds, line) {
    const before = this.pictures.get(robot) ?? [];
    const kept = (before.at(-1)?.seconds ?? 0) > seconds ? [] : before;
    keep(kept, { seconds, line }, this.most);
    this.pictures.set(robot, kept);
  }

  /**
   * @param {string} robot its key
   * @param {number} seconds
   * @returns {readonly import('./telemetry.js').Drawing[]} the picture of that moment
   */
  at(robot, seconds) {
    const picture = latest(this.pictures.get(robot) ?? [], seconds);
    const told = picture && seconds - picture.seconds < DRAWING_SECONDS ? readTelemetry(picture.line) : undefined;
    return told?.kind === 'draw' ? told.drawings : [];
  }
}
