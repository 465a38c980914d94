/** Exports the open recording to files, with a progress bar and a cancel button. */
import { byId, offer } from '../panels/elements.js';
import { pageOf, tableOf } from './exports.js';
import { loadLog } from './recording-api.js';

/**
 * @typedef {import('./exports.js').RecordingFile} RecordingFile
 * @typedef {import('./exports.js').Section} Section
 * @typedef {import('./exports.js').Progress} Progress
 *
 * @typedef {object} Source
 * @property {Record<string, import('../state/kinematics.js').RobotModel>} models
 * @property {(text: string) => void} note
 * @property {() => RecordingFile | undefined} file
 * @property {() => Section} section the section to export
 * @property {() => import('../field/camera-controller.js').CameraController} camera returns the camera used for videos
 */

/** Thrown when the user has cancelled the export. */
class Cancelled extends Error {}

/** Progress bar with a cancel button. */
class ProgressLine {
  #isCancelled = false;
  isBusy = false;

  constructor() {
    this.place = byId('export-progress');
    this.bar = /** @type {HTMLProgressElement} */ (this.place.querySelector('progress'));
    this.place.querySelector('button')?.addEventListener('click', () => {
      this.#isCancelled = true;
    });
  }

  /** @param {(progress: Progress) => Promise<void>} work */
  async watch(work) {
    this.#isCancelled = false;
    this.isBusy = true;
    this.bar.value = 0;
    this.place.hidden = false;
    try {
      await work((part) => {
        this.bar.value = part;
        if (this.#isCancelled) {
          throw new Cancelled();
        }
      });
    } finally {
      this.isBusy = false;
      this.place.hidden = true;
    }
  }
}

export class ExportController {
  #line = new ProgressLine();

  /** @param {Source} source */
  constructor(source) {
    this.source = source;
  }

  /** Actions of the export buttons. */
  get actions() {
    return {
      csv: () => this.#save('csv', tableOf),
      log: () => this.#save('log.gz', ({ name }) => loadLog(name)),
      html: () => this.#save('html', pageOf),
      video: () => this.#save('webm', (...given) => this.#video(...given)),
    };
  }

  /** @param {RecordingFile} file @param {Source['models']} models @param {Section} section @param {Progress} progress */
  async #video(file, models, section, progress) {
    const { videoOf } = await import('./video.js');
    return videoOf(file, models, section, progress, this.source.camera());
  }

  /**
   * @param {string} ending extension of the file
   * @param {(file: RecordingFile, models: Source['models'], section: Section, progress: Progress) => Promise<Blob>} make
   */
  async #save(ending, make) {
    const { models, note } = this.source;
    const file = this.source.file();
    if (!file) {
      return;
    }
    if (this.#line.isBusy) {
      note('Another export is running: cancel it, or wait for it to finish.');
      return;
    }
    try {
      await this.#line.watch(async (progress) => {
        offer(`${file.name}.${ending}`, await make(file, models, this.source.section(), progress));
      });
    } catch (error) {
      const text = /** @type {Error} */ (error).message;
      note(error instanceof Cancelled ? 'The export was cancelled.' : `The export failed: ${text}`);
    }
  }
}
