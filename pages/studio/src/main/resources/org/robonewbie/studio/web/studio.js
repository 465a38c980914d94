/** The studio: connects the simulation, picture, rooms and panels. */
import { FieldRoom } from './field/field-room.js';
import { overSocket } from './live/connection.js';
import { Session } from './live/session.js';
import { Commentary } from './panels/commentary.js';
import { CoursePanel } from './panels/course-panel.js';
import { DiagnosticsList } from './panels/diagnostics-list.js';
import { byId } from './panels/elements.js';
import { watchFreeSpace } from './panels/free-space.js';
import { FIELD_MOUSE, fieldActions, listenToKeys } from './panels/keys.js';
import { FirstSteps } from './panels/first-steps.js';
import { EventList } from './panels/event-list.js';
import { banner, notes, reportMistakes, showBanner } from './panels/messages.js';
import { PuppetPanel } from './panels/puppet-panel.js';
import { RoomController } from './panels/room-controller.js';
import { paced } from './panels/pace.js';
import { offerRoom, roomsPanel } from './panels/rooms.js';
import { scenePanel } from './panels/scene-panel.js';
import { scoreBoardPanel } from './panels/score-board.js';
import { cameraPanel, trainerPanel } from './panels/side.js';
import { themeSwitch } from './panels/theme.js';
import { timeLineActions, timeLinePanel } from './panels/time-line.js';
import { timeActions, transportPanel } from './panels/transport.js';
import { welcomeNewcomer } from './panels/welcome.js';
import { Workspace } from './panels/workspace.js';
import { ProgramService } from './program/program-service.js';
import { matchEventText } from './state/match-events.js';
import { message } from './state/studio-state.js';

/** Faster updates are unreadable, and text layout takes time that the picture needs. */
const PANEL_MILLISECONDS = 90;
const LOOK_MILLISECONDS = 500;
const MAX_TURN_SECONDS = 0.2;
const CYCLES_PER_SECOND = 50;

export class Studio {
  #hasDrawn = false;
  #lastTurn = 0;
  /** @type {Array<(shown: import('./state/studio-state.js').StudioState, now: number) => void>} */
  #draws = [];
  #panels = paced((now) => this.#drawPanels(now), PANEL_MILLISECONDS);

  /**
   * @param {URLSearchParams} options query parameters of the page's address
   * @param {(listener: import('./live/connection.js').Listener) => import('./live/connection.js').Line} [connect]
   */
  constructor(options, connect = overSocket) {
    this.options = options;
    this.note = notes();
    reportMistakes(this.note);
    this.session = new Session({
      begun: () => (this.rooms?.forget(), this.field?.board.clear()),
      telemetry: (news) => this.rooms.receive(news),
      happened: (event, teams) => this.eventList?.show(matchEventText(event, teams)),
      drawn: (sets) => this.field.board.receive(sets),
      diagnostic: (diagnostic) => this.diagnostics?.add(diagnostic),
      note: this.note,
    });
    showBanner(message(this.state, 0));
    this.firstSteps = new FirstSteps();
    this.field = new FieldRoom(this.session, options.get('quality'), {
      isSteered: () => ['field', 'robot', 'program'].includes(this.room()) && this.session.shown.tense === 'live',
      send: this.send,
    });
    this.connection = connect(this.session);
    this.time = timeActions(() => this.state, this.send);
    this.rooms = this.#makeRooms();
    this.drawTimeLine = timeLinePanel(this.cursor, this.touch);
    this.workspace = new Workspace((room) => this.rooms.enter(room));
    this.room = roomsPanel((entered) => this.#enter(entered));
  }

  /** Builds the page, connects to the simulator and starts drawing. */
  start() {
    this.#build();
    this.#listen();
    setInterval(() => {
      this.connection.checkSilence();
      this.#drawPanels(performance.now());
      this.workspace.markMore();
    }, LOOK_MILLISECONDS);
    this.connection.open();
    this.#offerPrograms()
      .catch((error) => this.note(error.message))
      .finally(() => this.rooms.chosen());
    requestAnimationFrame(this.#turn);
  }

  /** Shows the link to the program room if the studio can run programs, and opens the room for newcomers. */
  async #offerPrograms() {
    const programs = await new ProgramService().list();
    offerRoom('#program', programs.open);
    await welcomeNewcomer(programs);
  }

  get state() {
    return this.session.state;
  }

  get cursor() {
    return this.session.cursor;
  }

  get view() {
    return this.field.view;
  }

  get camera() {
    return this.field.cameraController;
  }

  get pointer() {
    return this.field.pointer;
  }

  get chooser() {
    return this.field.chooser;
  }

  get drawings() {
    return this.field.drawings;
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

  announce = (/** @type {string} */ starting) => this.session.announce(starting);

  goLive = () => this.session.travel((cursor) => cursor.goLive());

  /** @param {{do?: string}} command */
  send = (command) => {
    this.connection.send(command);
    if (command.do === 'placeBall' || command.do === 'walk') {
      this.firstSteps.done(command.do === 'walk' ? 'puppet' : 'ball');
    }
  };

  /** @param {string} team @param {number} number */
  #lookInside = (team, number) => {
    const robots = this.state.scene?.robots ?? [];
    const index = robots.findIndex((player) => player.team === team && player.number === number);
    if (index >= 0) {
      this.camera.choose(index);
    }
    location.hash = '#robot';
  };

  /** Wraps an action so that the picture is redrawn afterwards. @template {unknown[]} A @param {(...given: A) => void} action */
  #withRedraw(action) {
    return (/** @type {A} */ ...given) => {
      action(...given);
      this.touch();
    };
  }

  #makeRooms() {
    return new RoomController({
      note: this.note,
      clearErrors: () => this.diagnostics?.clear(),
      quality: () => this.chooser.quality,
      robotOfRun: () => this.session.robot(this.camera.chosen),
      send: this.send,
      goLive: this.goLive,
      announce: this.announce,
      camera: () => this.camera,
      hasClock: () => this.state.scene?.clock !== false,
      robots: () => this.session.shown.scene?.robots ?? [],
      isPitchEmpty: () => this.state.scene?.puppets === true && this.state.scene.robots.length === 0,
      goTo: (seconds) => this.session.travel((cursor) => cursor.goTo(seconds * CYCLES_PER_SECOND)),
    });
  }

  #build() {
    const puppet = new PuppetPanel({
      now: () => this.state,
      chosen: () => this.camera.chosen,
      choose: this.#withRedraw((/** @type {number} */ index) => this.camera.choose(index)),
      isHere: () => this.room() === 'field',
      send: this.send,
    });
    this.#draws = [
      scoreBoardPanel(),
      transportPanel(this.time),
      cameraPanel(this.camera, {
        choose: this.field.chooseCamera,
        view: this.view,
        show: this.field.showBeside,
      }),
      trainerPanel(this.send),
      scenePanel(this.note, this.goLive),
      banner(),
      (shown) => puppet.draw(shown),
      () => this.firstSteps.show(this.state),
    ];
    this.eventList = new EventList();
    this.commentary = new Commentary(this.session, (text) => this.eventList?.show(text));
    this.diagnostics = new DiagnosticsList(this.#lookInside);
    this.puppet = puppet;
    this.course = new CoursePanel(this.note, this.goLive, this.announce, this.field.showGhost);
    const shadows = this.options.get('shadows');
    if (shadows) {
      this.view.setShadows(shadows === 'on');
    }
  }

  #listen() {
    const field = {
      actions: [...fieldActions(this.field.looks, this.time, this.send), this.drawings.action],
      mouse: FIELD_MOUSE,
    };
    listenToKeys(() => {
      const keys = this.rooms.keys(this.room(), field);
      const more = this.room() === 'replay' ? [this.drawings.action] : timeLineActions(this.cursor, this.touch);
      return { ...keys, actions: [...keys.actions, ...more] };
    });
    const setTheme = this.#withRedraw((/** @type {'light' | 'dark'} */ theme) => {
      this.view.setTheme(theme);
      this.motion?.setTheme(theme);
    });
    themeSwitch(this.options.get('theme'), setTheme);
    window.addEventListener('beforeunload', (event) => this.rooms.isAtRisk && event.preventDefault());
    const setCovered = (/** @type {import('./field/field-view.js').FieldView['covered']} */ covered) => {
      this.view.setCovered(covered);
      this.camera.refit();
    };
    watchFreeSpace(this.view.stage, this.#withRedraw(setCovered));
  }

  /** @param {import('./panels/rooms.js').RoomName} entered */
  async #enter(entered) {
    if (this.cursor.recorded?.running && entered !== 'replay') {
      this.cursor.goLive(); // other rooms control the running simulation
    }
    this.touch();
    this.workspace.enter(entered);
    if (entered === 'motion') {
      this.firstSteps.done('motion');
    }
    this.#drawPanels(performance.now());
    await this.rooms.enter(entered);
    if (entered === 'replay' && this.cursor.cycle !== undefined) {
      this.replay?.showRunning(this.cursor.cycle);
    }
  }

  /** Redraws if anything has changed; nothing is drawn while the world and the camera are still. */
  #turn = (/** @type {number} */ now) => {
    requestAnimationFrame(this.#turn);
    if (this.#hasDrawn) {
      this.field.pictureTook(now - this.#lastTurn);
    }
    this.#turnRoom(now, Math.min(MAX_TURN_SECONDS, (now - this.#lastTurn) / 1000));
    this.puppet?.readGamepad();
    this.commentary?.turn(Math.min(MAX_TURN_SECONDS, (now - this.#lastTurn) / 1000));
    this.#panels.turn(now);
    this.#lastTurn = now;
    if (this.session.owesAnswer) {
      this.session.owesAnswer = false;
      this.send({ do: 'seen' });
    }
  };

  /** @param {number} now milliseconds @param {number} seconds since the last call */
  #turnRoom(now, seconds) {
    const here = this.room();
    this.#hasDrawn = this.#mustDraw(here, now, seconds);
    if (this.#hasDrawn) {
      this.#drawPicture(now, seconds);
    } else if (here === 'motion') {
      this.motion?.turn(seconds);
    } else if (!this.chooser.fixed) {
      this.view.refine(now);
    }
    if (this.workspace.showsRobot && this.robot) {
      this.workspace.agreeOnRobot(this.camera, this.robot.watch);
      this.robot.turn(this.session.shown, this.cursor, now);
    }
  }

  /** @param {import('./panels/rooms.js').RoomName} here @param {number} now @param {number} seconds */
  #mustDraw(here, now, seconds) {
    if (here === 'replay') {
      return this.replay?.turn(seconds) === true || this.session.stale;
    }
    return here !== 'motion' && (this.session.stale || this.field.isMoving(now));
  }

  /** @param {number} now milliseconds @param {number} seconds since the last call */
  #drawPicture(now, seconds) {
    const recorded = this.room() === 'replay' ? this.replay?.picture : undefined;
    if (recorded) {
      this.cursor.goToRecorded(recorded);
    }
    this.field.draw(now, seconds);
    this.#panels.ask();
  }

  /** @param {number} now milliseconds */
  #drawPanels(now) {
    const shown = this.session.onPanels;
    this.#draws.forEach((draw) => draw(shown, now));
    const { tense } = this.session.shown;
    this.drawTimeLine(tense, ['motion', 'replay'].includes(this.room()));
    byId('score-board').hidden ||= this.room() === 'replay' && tense !== 'recorded';
    byId('gone').hidden = shown.connection !== 'lost' || !byId('field-room').hidden;
  }
}
