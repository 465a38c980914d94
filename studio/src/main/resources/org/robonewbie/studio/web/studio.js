/** The studio: brings connection, picture, rooms and panels together. */
import { CameraDesk, CAMERAS } from './field/camera-desk.js';
import { Hand } from './field/hand.js';
import { chooserFor, openView } from './field/open-view.js';
import { Connection } from './live/connection.js';
import { Session } from './live/session.js';
import { CoursePanel } from './panels/course-panel.js';
import { DrawingDesk } from './panels/drawing-desk.js';
import { byId } from './panels/elements.js';
import { watchFreeSpace } from './panels/free-space.js';
import { FIELD_MOUSE, fieldDeeds, listenToKeys } from './panels/keys.js';
import { Happenings } from './panels/happenings.js';
import { banner, notes, reportMistakes, tell } from './panels/messages.js';
import { PuppetPanel } from './panels/puppet-panel.js';
import { RoomDesk } from './panels/room-desk.js';
import { paced } from './panels/pace.js';
import { roomsPanel } from './panels/rooms.js';
import { scenePanel } from './panels/scene-panel.js';
import { scoreBoardPanel } from './panels/score-board.js';
import { cameraPanel, trainerPanel } from './panels/side.js';
import { themeSwitch } from './panels/theme.js';
import { timeLineDeeds, timeLinePanel } from './panels/time-line.js';
import { timeActions, transportPanel } from './panels/transport.js';
import { QUALITIES, qualityIndex } from './state/quality.js';
import { message } from './state/studio-state.js';

/** Nobody reads faster than that, and letting the browser lay out texts costs time that pictures need. */
const PANEL_MILLISECONDS = 90;
const LOOK_MILLISECONDS = 500;
const LONGEST_TURN_SECONDS = 0.2;
const CYCLES_PER_SECOND = 50;

export class Studio {
  #hasDrawn = false;
  #lastTurn = 0;
  /** The scene that the picture is made for. @type {object | undefined} */
  #pictured;
  /** @type {Array<(shown: import('./state/studio-state.js').StudioState, now: number) => void>} */
  #draws = [];
  #panels = paced((now) => this.#drawPanels(now), PANEL_MILLISECONDS);

  /** @param {URLSearchParams} options of the page's address */
  constructor(options) {
    this.options = options;
    this.token = options.get('token') ?? '';
    this.note = notes();
    reportMistakes(this.note);
    this.session = new Session(this.token !== '', {
      begun: () => this.robot?.forget(),
      telemetry: (news) => this.robot?.hear(news),
      happened: (event, teams) => this.happenings?.add(event, teams),
      note: this.note,
    });
    tell(message(this.state, 0));
    const asked = qualityIndex(options.get('quality'));
    this.view = openView(QUALITIES[asked < 0 ? 1 : asked]);
    this.chooser = chooserFor(this.view, asked);
    this.desk = new CameraDesk(this.view.camera, () => this.view.free);
    const address = `ws://${location.host}/live?token=${encodeURIComponent(this.token)}`;
    this.connection = new Connection(address, this.session);
    this.time = timeActions(() => this.state, this.send);
    this.rooms = this.#makeRooms();
    this.drawings = new DrawingDesk(this.view, this.touch);
    this.drawTimeLine = timeLinePanel(this.cursor, this.touch);
    this.room = roomsPanel((entered) => this.#enter(entered));
  }

  /** Furnishes the page, calls the simulator and begins to draw. */
  start() {
    this.#furnish();
    this.#listen();
    setInterval(() => {
      this.connection.checkSilence();
      this.#drawPanels(performance.now());
    }, LOOK_MILLISECONDS);
    if (this.token !== '') {
      this.connection.open();
    }
    requestAnimationFrame(this.#turn);
  }

  get state() {
    return this.session.state;
  }

  get cursor() {
    return this.session.cursor;
  }

  get motion() {
    return this.rooms.motion;
  }

  get robot() {
    return this.rooms.robot;
  }

  get replay() {
    return this.rooms.replay;
  }

  touch = () => this.session.touch();

  goLive = () => this.session.travel((cursor) => cursor.goLive());

  /** @param {object} command */
  send = (command) => this.connection.send(command);

  /** Asks for another picture after something was done to it. @template {unknown[]} A @param {(...given: A) => void} deed */
  #touching(deed) {
    return (/** @type {A} */ ...given) => {
      deed(...given);
      this.touch();
    };
  }

  #makeRooms() {
    return new RoomDesk({
      token: this.token,
      note: this.note,
      quality: () => this.chooser.quality,
      robotOfRun: () => this.session.robot(this.desk.chosen),
      send: this.send,
      goLive: this.goLive,
      hasClock: () => this.state.scene?.clock !== false,
      goTo: (seconds) => this.session.travel((cursor) => cursor.goTo(seconds * CYCLES_PER_SECOND)),
    });
  }

  #furnish() {
    const shadows = this.options.get('shadows') === 'on';
    const setShadows = this.#touching((/** @type {boolean} */ on) => this.view.setShadows(on));
    const puppet = new PuppetPanel({
      now: () => this.state,
      chosen: () => this.desk.chosen,
      choose: this.#touching((/** @type {number} */ index) => this.desk.choose(index)),
      isHere: () => this.room() === 'field',
      send: this.send,
    });
    this.#draws = [
      scoreBoardPanel(),
      transportPanel(this.time),
      cameraPanel(this.desk, { choose: this.#chooseCamera, shadows, setShadows }),
      trainerPanel(this.send),
      scenePanel(this.token, this.note, this.goLive),
      banner(),
      (shown) => puppet.draw(shown),
    ];
    this.happenings = new Happenings();
    this.course = new CoursePanel(this.token, this.note, this.goLive);
    setShadows(shadows);
    this.#putHandOnField();
  }

  #putHandOnField() {
    const isSteered = () => this.room() === 'field' && this.session.shown.tense === 'live';
    this.hand = new Hand(this.view, this.desk, {
      now: () => ({ ...this.state, ...this.session.shown }),
      send: (command) => isSteered() && this.send(command),
      changed: this.touch,
    });
  }

  #listen() {
    const field = { deeds: [...this.#fieldDeeds(), this.drawings.deed], mouse: FIELD_MOUSE };
    listenToKeys(() => {
      const keys = this.rooms.keys(this.room(), field);
      const more = this.room() === 'replay' ? [this.drawings.deed] : timeLineDeeds(this.cursor, this.touch);
      return { ...keys, deeds: [...keys.deeds, ...more] };
    });
    const setTheme = this.#touching((/** @type {'light' | 'dark'} */ theme) => {
      this.view.setTheme(theme);
      this.motion?.setTheme(theme);
    });
    themeSwitch(this.options.get('theme'), setTheme);
    window.addEventListener('beforeunload', (event) => this.motion?.editor.isAtRisk && event.preventDefault());
    const setCovered = (/** @type {import('./field/field-view.js').FieldView['covered']} */ covered) => {
      this.view.setCovered(covered);
      this.desk.refit();
    };
    watchFreeSpace(this.view.stage, this.#touching(setCovered));
  }

  #fieldDeeds() {
    const { desk } = this;
    return fieldDeeds(
      {
        turn: this.#touching((/** @type {number} */ right, /** @type {number} */ up) => desk.turn(right, up)),
        zoom: this.#touching((/** @type {number} */ factor) => desk.zoom(factor)),
        camera: (index) => this.#chooseCamera(CAMERAS[index].mode),
        next: this.#touching(() => desk.choose((desk.chosen + 1) % Math.max(1, this.state.scene?.robots.length ?? 1))),
      },
      this.time,
      this.send,
    );
  }

  #chooseCamera = this.#touching((/** @type {import('./field/camera-desk.js').CameraMode} */ mode) =>
    this.desk.setMode(mode),
  );

  /** @param {import('./panels/rooms.js').RoomName} entered */
  async #enter(entered) {
    const { recorded } = this.cursor;
    if (recorded?.running && entered !== 'replay') {
      this.cursor.goTo(recorded.frame.cycle);
    }
    this.touch();
    this.#drawPanels(performance.now());
    await this.rooms.enter(entered);
    if (entered === 'replay' && this.cursor.cycle !== undefined) {
      this.replay?.showRunning(this.cursor.cycle);
    }
  }

  /** Draws if anything has changed. Nothing is drawn while the world and the eye stand still. */
  #turn = (/** @type {number} */ now) => {
    requestAnimationFrame(this.#turn);
    this.#chooseQuality(now - this.#lastTurn);
    this.#turnRoom(now, Math.min(LONGEST_TURN_SECONDS, (now - this.#lastTurn) / 1000));
    this.#panels.turn(now);
    this.#lastTurn = now;
    if (this.session.owesAnswer) {
      this.session.owesAnswer = false;
      this.send({ do: 'seen' });
    }
  };

  /** @param {number} milliseconds that the last turn took */
  #chooseQuality(milliseconds) {
    if (this.#hasDrawn && this.chooser.pictureTook(milliseconds)) {
      this.view.setQuality(this.chooser.quality);
      this.touch();
    }
  }

  /** @param {number} now milliseconds @param {number} seconds since the last turn */
  #turnRoom(now, seconds) {
    const here = this.room();
    this.#hasDrawn = this.#mustDraw(here, now, seconds);
    if (this.#hasDrawn) {
      this.#drawPicture(now, seconds);
    } else if (here === 'motion') {
      this.motion?.turn(seconds);
    } else if (here === 'robot') {
      this.robot?.turn(this.session.shown, this.cursor, now);
    } else if (!this.chooser.fixed) {
      this.view.refine(now);
    }
  }

  /** @param {import('./panels/rooms.js').RoomName} here @param {number} now @param {number} seconds */
  #mustDraw(here, now, seconds) {
    if (here === 'replay') {
      return this.replay?.turn(seconds) === true || this.session.stale;
    }
    return here === 'field' && (this.session.stale || (this.#isSmooth() && this.session.smoothing.isMoving(now)));
  }

  #isSmooth() {
    return this.session.shown.tense === 'live' && this.chooser.quality.smooth;
  }

  /** @param {number} now milliseconds @param {number} seconds since the last turn */
  #drawPicture(now, seconds) {
    const { session, view, desk } = this;
    const recorded = this.room() === 'replay' ? this.replay?.picture : undefined;
    if (recorded) {
      this.cursor.goToRecorded(recorded);
    }
    const { scene, frame } = session.shown;
    this.#setScene(scene);
    const picture = this.#isSmooth() ? session.smoothing.picture(now) : frame;
    if (picture && picture.robots.length === scene?.robots.length) {
      view.update(picture);
    }
    this.drawings.show(session.shown, session.drawings);
    session.stale = desk.update(view.crowd.poses, seconds, view.ball.position.toArray());
    view.light.shine(desk.shown.target, view.camera.position);
    view.draw();
    this.#panels.ask();
  }

  /** @param {import('./live/state-frame.js').Scene | undefined} scene */
  #setScene(scene) {
    if (scene && scene !== this.#pictured) {
      this.#pictured = scene;
      this.view.setScene(scene);
      this.desk.setScene(scene);
    }
  }

  /** @param {number} now milliseconds */
  #drawPanels(now) {
    const shown = this.session.onPanels;
    this.#draws.forEach((draw) => draw(shown, now));
    this.drawTimeLine(this.session.shown.tense, this.room() === 'replay');
    byId('gone').hidden = shown.connection !== 'lost' || !byId('field-room').hidden;
  }
}
