/** The 3D view of the pitch: picture, camera, pointer, drawings and name tags at the session's current moment. */
import { BoardController } from '../panels/board-controller.js';
import { DrawingController } from '../panels/drawing-controller.js';
import { byId, setText } from '../panels/elements.js';
import { QUALITIES, QualityChooser, qualityIndex, qualityRange } from '../state/quality.js';
import { CameraController, CAMERAS } from './camera-controller.js';
import { FieldView } from './field-view.js';
import { Ghosts } from './ghosts.js';
import { PointerController } from './pointer-controller.js';

/** @typedef {import('./camera-controller.js').CameraMode} CameraMode */

export class FieldRoom {
  /** The scene the picture was built for. @type {object | undefined} */
  #pictured;

  /**
   * @param {import('../live/session.js').Session} session
   * @param {string | null} quality requested in the page's address
   * @param {object} world
   * @param {() => boolean} world.isSteered whether objects can be moved now
   * @param {(command: object) => void} world.send
   */
  constructor(session, quality, { isSteered, send }) {
    this.session = session;
    const asked = qualityIndex(quality);
    this.view = new FieldView(byId('stage'), QUALITIES[asked < 0 ? 1 : asked]);
    this.chooser = chooserFor(this.view, asked);
    this.ghosts = new Ghosts(this.view.scene, this.view.quality);
    this.cameraController = new CameraController(this.view.camera, () => this.view.free);
    this.drawings = new DrawingController(this.view, () => session.touch());
    this.board = new BoardController(this.view.board, () => session.touch());
    this.pointer = new PointerController(this.view, this.cameraController, {
      now: () => ({ ...session.state, ...session.shown }),
      isSteered,
      send: (command) => isSteered() && send(command),
      changed: () => session.touch(),
      showTip,
    });
  }

  /** @param {CameraMode} mode */
  chooseCamera = (mode) => {
    this.cameraController.setMode(mode);
    this.session.touch();
  };

  /** @param {import('../panels/side.js').Picture} shown */
  showBeside = ({ names, trail, shadows }) => {
    if (shadows !== undefined) {
      this.view.setShadows(shadows);
    }
    this.view.names.isOn = names;
    this.view.trail.isOn = trail;
    this.session.touch();
  };

  /** @param {boolean} on whether the previous trial of an exercise is shown alongside the current one */
  showGhost = (on) => {
    this.session.ghost.isOn = on;
    this.session.touch();
  };

  /** Key actions that change the view. */
  get looks() {
    const { cameraController, session } = this;
    return {
      turn: (/** @type {number} */ right, /** @type {number} */ up) => {
        cameraController.turn(right, up);
        session.touch();
      },
      zoom: (/** @type {number} */ factor) => {
        cameraController.zoom(factor);
        session.touch();
      },
      select: (/** @type {number} */ index) => this.chooseCamera(CAMERAS[index].mode),
      next: () => {
        cameraController.choose((cameraController.chosen + 1) % Math.max(1, session.state.scene?.robots.length ?? 1));
        session.touch();
      },
    };
  }

  /** Adapts the quality to the computer. @param {number} milliseconds time taken to render the last picture */
  pictureTook(milliseconds) {
    if (this.chooser.pictureTook(milliseconds)) {
      this.view.setQuality(this.chooser.quality);
      this.session.touch();
    }
  }

  get #isSmooth() {
    return this.session.shown.tense === 'live' && this.chooser.quality.smooth;
  }

  /** @param {number} now milliseconds @returns {boolean} whether the picture changes without new data */
  isMoving(now) {
    return this.#isSmooth && this.session.smoothing.isMoving(now);
  }

  /** @param {number} now milliseconds @param {number} seconds since the last call */
  draw(now, seconds) {
    const { session, view, cameraController } = this;
    const { scene, frame } = session.shown;
    this.#setScene(scene);
    const picture = this.#isSmooth ? session.smoothing.picture(now) : frame;
    if (frame && picture && picture.robots.length === scene?.robots.length) {
      view.update(picture);
      view.trail.follow(frame.cycle, frame.ball);
    }
    this.ghosts.show(session.ghost.beside(scene, frame), view.camera.position);
    this.drawings.show(session.shown, session.drawings);
    view.board.group.visible = session.shown.tense === 'live';
    this.pointer.draw();
    session.stale = view.look(cameraController, seconds);
    view.draw();
  }

  /** @param {import('../live/state-frame.js').Scene | undefined} scene */
  #setScene(scene) {
    if (scene && scene !== this.#pictured) {
      this.#pictured = scene;
      this.view.setScene(scene);
      this.cameraController.setScene(scene);
    }
  }
}

/** @param {FieldView} view @param {number} asked index of the quality requested in the page's address, negative for none */
function chooserFor(view, asked) {
  const isFixed = asked >= 0;
  const range = isFixed ? { first: asked, highest: asked } : qualityRange(view.graphics);
  const chooser = new QualityChooser(range, isFixed);
  if (!isFixed) {
    view.setQuality(chooser.quality);
  }
  return chooser;
}

/** @param {string} tip hint on using the mouse; empty for none */
function showTip(tip) {
  const place = byId('stage-tip');
  setText(place, tip || place.textContent || '');
  place.hidden = tip === '';
}
