/** Opens recordings from the studio's server, and follows those that are still being written. */
import { notesOf, picturesOf } from '../state/replay/notes.js';
import { RecordedRun } from '../state/replay/recorded-run.js';
import { DrawingMemory } from '../state/robot/drawing-memory.js';
import { loadGrowth, loadIndex, loadNotes, loadPiece } from './recording-api.js';

const FOLLOW_MILLISECONDS = 1000;

/** An open recording. */
export class RecordingFile {
  /**
   * @param {string} name
   * @param {Record<string, import('../state/kinematics.js').RobotModel>} models
   * @param {() => void} grown
   */
  constructor(name, models, grown) {
    this.name = name;
    this.grown = grown;
    this.run = new RecordedRun(
      (type) => models[type].hinges.length,
      (piece, skip) => loadPiece(name, piece, skip),
      grown,
    );
    /** @type {import('../state/replay/recording-reader.js').RecordedEvent[]} log lines */
    this.notes = [];
    this.noteBytes = 0;
    /** @type {string[]} telemetry lines with drawings */
    this.pictures = [];
    this.drawings = new DrawingMemory(Infinity);
    this.open = true;
    /** Whether the events cover everything that had been recorded at the last request. */
    this.isWhole = false;
    this.timer = 0;
  }

  /** @param {boolean} follows whether the run is still being recorded */
  async load(follows) {
    const index = await loadIndex(this.name);
    this.run.summary = index;
    this.run.grow(index);
    await this.#readOn(index.whole);
    await this.#loadNotes();
    this.isWhole = true;
    this.grown();
    this.#follow(follows);
  }

  /** All events marked on the time line. */
  get events() {
    return [...this.run.events, ...this.notes];
  }

  /** Whether all robots are NAOs, so that the run can be saved as a SimSpark log. */
  get isOfNaos() {
    return Object.keys(this.run.summary.models ?? {}).length === 0;
  }

  close() {
    this.open = false;
    clearTimeout(this.timer);
  }

  /** @param {boolean} isWhole */
  async #readOn(isWhole) {
    this.grown();
    let { length: events } = this.run.events;
    for (let whole = isWhole; !whole && this.open;) {
      const growth = await loadGrowth(this.name, events, this.run.starts.length);
      this.run.grow(growth);
      events = this.run.events.length;
      whole = growth.whole;
      this.grown();
    }
  }

  async #loadNotes() {
    const { lines, bytes } = await loadNotes(this.name, this.noteBytes);
    this.noteBytes += bytes;
    const pictures = picturesOf(lines);
    this.notes.push(...notesOf(lines, this.run.firstCycle));
    this.drawings.receive(pictures);
    this.pictures.push(...pictures);
  }

  /** @param {boolean} follows */
  #follow(follows) {
    if (follows && this.open) {
      const look = async () => {
        await this.#readOn(false);
        await this.#loadNotes();
      };
      this.timer = window.setTimeout(
        () =>
          look().then(
            () => this.#follow(true),
            () => {},
          ),
        FOLLOW_MILLISECONDS,
      );
    }
  }
}
