/** Drawings of all robots over time, for looking back at the last minute. Pure. */
import { DRAWING_SECONDS, keep, latest } from './robot-memory.js';
import { readTelemetry } from './telemetry.js';

/** Number of sets of drawings kept per robot: one minute if a robot draws in every frame of the live view. */
const MAX_PICTURES = 1500;

export class DrawingMemory {
  /** @param {number} [max] maximum number of sets of drawings per robot */
  constructor(max = MAX_PICTURES) {
    this.max = max;
    /** Lines are parsed on demand, because few of them are ever drawn. @type {Map<string, Array<{seconds: number, line: string}>>} */
    this.pictures = new Map();
    /** @type {Map<string, Set<string>>} kinds of drawings made by each robot */
    this.kinds = new Map();
  }

  /** @param {readonly string[]} lines lines of telemetry; lines without drawings are ignored */
  receive(lines) {
    for (const line of lines.filter((each) => each.startsWith('draw\t'))) {
      const item = readTelemetry(line);
      if (item.kind === 'draw') {
        this.#keep(item.robot, item.seconds, line);
        const kinds = this.kinds.get(item.robot) ?? new Set();
        item.drawings.forEach(({ shape }) => kinds.add(shape));
        this.kinds.set(item.robot, kinds);
      }
    }
  }

  /**
   * Stores drawings. If they are older than the last ones, the simulation has been restarted, and they replace all earlier ones.
   *
   * @param {string} robot
   * @param {number} seconds
   * @param {string} line
   */
  #keep(robot, seconds, line) {
    const before = this.pictures.get(robot) ?? [];
    const kept = (before.at(-1)?.seconds ?? 0) > seconds ? [] : before;
    keep(kept, { seconds, line }, this.max);
    this.pictures.set(robot, kept);
  }

  /** @param {string} robot key of the robot
   * @param {number} seconds
   * @returns {readonly import('./telemetry.js').Drawing[]} the drawings at that time
   */
  at(robot, seconds) {
    const picture = latest(this.pictures.get(robot) ?? [], seconds);
    const item = picture && seconds - picture.seconds < DRAWING_SECONDS ? readTelemetry(picture.line) : undefined;
    return item?.kind === 'draw' ? item.drawings : [];
  }
}
