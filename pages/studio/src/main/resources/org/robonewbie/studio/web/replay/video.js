/**
 * Exports recordings as videos: each frame is rendered at its exact time, regardless of rendering speed, and encoded by the browser.
 */
import { CameraController } from '../field/camera-controller.js';
import { FieldView } from '../field/field-view.js';
import { element } from '../panels/elements.js';
import { QUALITIES, qualityIndex } from '../state/quality.js';
import { frameOf, MOMENTS_PER_SECOND } from '../state/replay/replay-state.js';
import { webmOf } from '../state/replay/webm.js';
import { clock } from '../state/studio-state.js';
import { SceneMemory } from './scene-memory.js';

/**
 * @typedef {import('../state/replay/recording-reader.js').Moment} Moment
 * @typedef {import('../state/replay/webm.js').EncodedPicture} EncodedPicture
 */

const [WIDTH, HEIGHT] = [1280, 720];
const PICTURES_PER_SECOND = 25;
const MOMENTS_PER_PICTURE = MOMENTS_PER_SECOND / PICTURES_PER_SECOND;
const PICTURES_PER_KEY = 2 * PICTURES_PER_SECOND;
const BITS_PER_SECOND = 3_000_000;
const MAX_WAITING = 4;
const MICROSECONDS = 1_000_000;

/** Codecs in order of preference, fastest first. @type {Array<{codec: string, name: 'V_VP8' | 'V_VP9'}>} */
const CODECS = [
  { codec: 'vp8', name: 'V_VP8' },
  { codec: 'vp09.00.31.08', name: 'V_VP9' },
];

const MISSING =
  'this browser cannot encode videos. Chrome, Edge and Chromium from version 94 and Firefox from version 130 can.';

/**
 * @param {import('./recordings.js').RecordingFile} file
 * @param {Record<string, import('../state/kinematics.js').RobotModel>} models
 * @param {import('./exports.js').Section} section
 * @param {import('./exports.js').Progress} progress
 * @param {CameraController} camera camera of the view to record
 * @returns {Promise<Blob>} a WebM file
 */
export async function videoOf({ run }, models, [from, to], progress, camera) {
  const count = Math.max(1, Math.ceil((to + 1 - from) / MOMENTS_PER_PICTURE));
  const film = await Encoding.open();
  const stage = new VideoStage(models, camera);
  try {
    for (let i = 0; i < count; i++) {
      const moment = await run.ready(Math.min(to, from + i * MOMENTS_PER_PICTURE));
      if (moment) {
        stage.draw(moment, run.header);
        await film.add(stage.canvas, i);
      }
      progress(i / count);
    }
    return await film.file(count);
  } finally {
    stage.close();
    film.close();
  }
}

/** Offscreen picture of the field at the size of the video, with score and time. */
class VideoStage {
  canvas = element('canvas', { width: String(WIDTH), height: String(HEIGHT) });
  #place = element('div', { class: 'video-stage', 'aria-hidden': 'true' });
  /** @type {import('../live/state-frame.js').Scene | undefined} */
  #scene;

  /** @param {Record<string, import('../state/kinematics.js').RobotModel>} models @param {CameraController} camera */
  constructor(models, camera) {
    document.body.append(this.#place);
    this.view = new FieldView(this.#place, QUALITIES[qualityIndex('high')]);
    this.view.setTheme(document.documentElement.dataset.theme === 'dark' ? 'dark' : 'light');
    this.view.renderer.setPixelRatio(1);
    this.view.renderer.setSize(WIDTH, HEIGHT);
    this.cameraController = new CameraController(this.view.camera);
    this.model = camera;
    this.scenes = new SceneMemory(models);
    this.pen = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext('2d', { willReadFrequently: true }));
  }

  /** @param {Moment} moment @param {Record<string, string>} header header of the recording */
  draw(moment, header) {
    const scene = this.scenes.at(moment, header);
    const isFirst = this.#scene === undefined;
    if (scene !== this.#scene) {
      this.#scene = scene;
      this.view.setScene(scene);
      this.cameraController.setScene(scene);
    }
    if (isFirst) {
      this.cameraController.lookAs(this.model);
    }
    this.view.update(frameOf(moment, scene));
    this.view.look(this.cameraController, isFirst ? 1 : 1 / PICTURES_PER_SECOND);
    this.view.draw();
    this.pen.drawImage(this.view.renderer.domElement, 0, 0, WIDTH, HEIGHT);
    this.#writeScore(moment);
  }

  /** @param {Moment} moment */
  #writeScore({ game, gameTime }) {
    const { pen } = this;
    const text = `${game.left} ${game.scoreLeft} : ${game.scoreRight} ${game.right}   ${clock(gameTime)}`.trim();
    pen.font = '600 26px system-ui, sans-serif';
    pen.textAlign = 'center';
    const width = pen.measureText(text).width + 40;
    pen.fillStyle = 'rgb(255 255 255 / 88%)';
    pen.fillRect((WIDTH - width) / 2, 18, width, 44);
    pen.fillStyle = '#17212b';
    pen.fillText(text, WIDTH / 2, 49);
  }

  close() {
    this.view.renderer.dispose();
    this.view.renderer.forceContextLoss();
    this.#place.remove();
  }
}

/** The browser's encoder and its output so far. */
class Encoding {
  /** @type {EncodedPicture[]} */
  #pictures = [];
  /** @type {Error | undefined} */
  #problem;

  /** @param {VideoEncoderConfig} settings @param {'V_VP8' | 'V_VP9'} name */
  constructor(settings, name) {
    this.name = name;
    this.encoder = new VideoEncoder({
      output: (chunk) => this.#take(chunk),
      error: (problem) => {
        this.#problem = problem;
      },
    });
    this.encoder.configure(settings);
  }

  /** @returns {Promise<Encoding>} @throws {Error} if the browser has no encoder; the message is meant for the user */
  static async open() {
    const common = { width: WIDTH, height: HEIGHT, bitrate: BITS_PER_SECOND, framerate: PICTURES_PER_SECOND };
    for (const { codec, name } of typeof VideoEncoder === 'undefined' ? [] : CODECS) {
      const { supported } = await VideoEncoder.isConfigSupported({ ...common, codec });
      if (supported) {
        return new Encoding({ ...common, codec }, name);
      }
    }
    throw new Error(MISSING);
  }

  /** @param {EncodedVideoChunk} chunk */
  #take(chunk) {
    const data = new Uint8Array(chunk.byteLength);
    chunk.copyTo(data);
    this.#pictures.push({ data, milliseconds: chunk.timestamp / 1000, isKey: chunk.type === 'key' });
  }

  /** @param {HTMLCanvasElement} canvas @param {number} index index of the frame */
  async add(canvas, index) {
    const duration = MICROSECONDS / PICTURES_PER_SECOND;
    const picture = new VideoFrame(canvas, { timestamp: index * duration, duration });
    this.encoder.encode(picture, { keyFrame: index % PICTURES_PER_KEY === 0 });
    picture.close();
    do {
      await yieldToPage();
    } while (this.encoder.encodeQueueSize > MAX_WAITING && !this.#problem);
    if (this.#problem) {
      throw this.#problem;
    }
  }

  /** @param {number} count number of frames @returns {Promise<Blob>} */
  async file(count) {
    await this.encoder.flush();
    const film = { codec: this.name, width: WIDTH, height: HEIGHT, milliseconds: (1000 * count) / PICTURES_PER_SECOND };
    return new Blob([webmOf(film, this.#pictures)], { type: 'video/webm' });
  }

  close() {
    if (this.encoder.state !== 'closed') {
      this.encoder.close();
    }
  }
}

/** Yields to the event loop. Unlike timers, this is not throttled in hidden pages. @returns {Promise<void>} */
function yieldToPage() {
  return new Promise((done) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      done();
    };
    port2.postMessage(undefined);
  });
}
