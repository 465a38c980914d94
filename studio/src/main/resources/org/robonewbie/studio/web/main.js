/** The studio: brings connection, state, picture and panels together. */
import { CameraDesk, CAMERAS } from './field/camera-desk.js';
import { FieldView } from './field/field-view.js';
import { Hand } from './field/hand.js';
import { Connection } from './live/connection.js';
import { readFrame } from './live/state-frame.js';
import { CoursePanel } from './panels/course-panel.js';
import { byId } from './panels/elements.js';
import { deeds, FIELD_MOUSE, listenToKeys } from './panels/keys.js';
import { Happenings } from './panels/happenings.js';
import { banner, notes, tell } from './panels/messages.js';
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
import { QualityChooser, QUALITIES, qualityIndex, qualityRange } from './state/quality.js';
import { Smoothing } from './state/smoothing.js';
import { initialState, message, withConnection, withFrame, withoutConnection, withRefusal, withScene } from './state/studio-state.js';
import { TimeCursor } from './state/time-cursor.js';

const options = new URLSearchParams(location.search);
const token = options.get('token') ?? '';

let state = initialState(token !== '');
let stale = true;
let owesAnswer = false;
let lastTurn = 0;
let hasDrawn = false;
/** The scene that the picture is made for. @type {object | undefined} */
let pictured;
const cursor = new TimeCursor();
/** Nobody reads faster than that, and letting the browser lay out texts costs time that pictures need. */
const panels = paced(drawPanels, 90);

const note = notes();
window.addEventListener('error', (event) => note(`This page has met an error: ${event.message}. Load it again.`));
window.addEventListener('unhandledrejection', (event) => note(`This page has met an error: ${event.reason}. Load it again.`));

tell(message(state, 0));

const asked = qualityIndex(options.get('quality'));
const view = openView(QUALITIES[asked < 0 ? 1 : asked]);
const chooser = new QualityChooser(
  asked < 0 ? qualityRange(view.graphics) : { first: asked, highest: asked },
  asked >= 0,
);
if (asked < 0) {
  view.setQuality(chooser.quality);
}
const desk = new CameraDesk(view.camera);
const smoothing = new Smoothing();

const connection = new Connection(`ws://${location.host}/live?token=${encodeURIComponent(token)}`, {
  opened() {
    state = withConnection(state);
    rooms.robot?.forget();
    cursor.restart();
    smoothing.clear();
    stale = true;
  },
  lost() {
    state = withoutConnection(state);
    owesAnswer = false;
    stale = true;
  },
  refused(reason) {
    state = withRefusal(state, reason);
    stale = true;
  },
  told(news) {
    if (news.kind === 'scene') {
      state = withScene(state, news);
    } else if (news.kind === 'telemetry') {
      rooms.robot?.hear(news);
    } else if (news.kind === 'event') {
      happenings.add(news.text, state.scene?.teams ?? { left: '', right: '' });
    } else {
      note(news.text);
    }
    stale = true;
  },
  frameArrived(bytes) {
    owesAnswer = true;
    const frame = state.scene && readFrame(bytes, state.scene);
    if (frame && state.scene) {
      cursor.history.push(frame.cycle, state.scene, bytes);
      state = withFrame(state, frame, performance.now());
      smoothing.push(frame, performance.now());
    }
    stale = true;
  },
});
/** @param {object} command */
const send = (command) => connection.send(command);
const touch = () => void (stale = true);

const time = timeActions(() => state, send);
/** @param {import('./field/camera-desk.js').CameraMode} mode */
const chooseCamera = (mode) => {
  desk.setMode(mode);
  touch();
};
const shadows = options.get('shadows') === 'on';
const setShadows = (/** @type {boolean} */ on) => (view.setShadows(on), touch());
const goLive = () => {
  cursor.goLive();
  touch();
};
const draws = [
  scoreBoardPanel(),
  transportPanel(time),
  cameraPanel(desk, { choose: chooseCamera, shadows, setShadows }),
  trainerPanel(send),
  scenePanel(token, note, goLive),
  banner(),
];
const happenings = new Happenings();
const drawTimeLine = timeLinePanel(cursor, touch);
const rooms = new RoomDesk({ token, note, quality: () => chooser.quality, robotOfRun, send, goLive, hasClock: () => state.scene?.clock !== false, goTo: (seconds) => (cursor.goTo(seconds * 50), touch()) });
const room = roomsPanel(enter);
new CoursePanel(token, note, goLive);
setShadows(shadows);
const puppet = new PuppetPanel({ now: () => state, chosen: () => desk.chosen, choose: (index) => (desk.choose(index), touch()), isHere: () => room() === 'field', send });
draws.push((shown) => puppet.draw(shown));
new Hand(view, desk, {
  now: () => ({ ...state, ...cursor.shown(state) }),
  send: (command) => room() === 'field' && cursor.shown(state).tense === 'live' && send(command),
  changed: touch,
});
const fieldDeeds = deeds(
  {
    turn: (right, up) => (desk.turn(right, up), touch()),
    zoom: (factor) => (desk.zoom(factor), touch()),
    camera: (index) => chooseCamera(CAMERAS[index].mode),
    next: () => (desk.choose((desk.chosen + 1) % Math.max(1, state.scene?.robots.length ?? 1)), touch()),
  },
  time,
  send,
);
const timeDeeds = timeLineDeeds(cursor, touch);
listenToKeys(() => {
  const { deeds, mouse } = rooms.keys(room(), { deeds: fieldDeeds, mouse: FIELD_MOUSE });
  return { deeds: room() === 'replay' ? deeds : [...deeds, ...timeDeeds], mouse };
});
themeSwitch(options.get('theme'), (theme) => {
  view.setTheme(theme);
  rooms.motion?.setTheme(theme);
  touch();
});
new ResizeObserver(() => {
  view.resize();
  touch();
}).observe(view.stage);

/** @param {import('./panels/rooms.js').RoomName} entered */
async function enter(entered) {
  const { recorded } = cursor;
  if (recorded?.running && entered !== 'replay') {
    cursor.goTo(recorded.frame.cycle);
  }
  touch();
  drawPanels(performance.now());
  await rooms.enter(entered);
  if (entered === 'replay' && cursor.cycle !== undefined) {
    rooms.replay?.showRunning(cursor.cycle);
  }
}

/** The robot that the field's camera follows, whose posture at the shown moment can become a keyframe. */
function robotOfRun() {
  const { tense, scene, frame } = cursor.shown(state);
  const player = scene?.robots[desk.chosen];
  const robot = frame?.robots[desk.chosen];
  const isThere = tense === 'recorded' || state.connection === 'live';
  return player && robot && isThere ? { name: `${player.team} ${player.number}`.trim() || 'the robot', degrees: robot.degrees } : undefined;
}

/** @param {import('./state/quality.js').Quality} quality */
function openView(quality) {
  try {
    return new FieldView(byId('stage'), quality);
  } catch (error) {
    tell({
      tone: 'trouble',
      title: 'This browser does not draw in three dimensions',
      text: 'Switch on WebGL (hardware acceleration) in its settings, or open this address in another browser.',
    });
    throw error;
  }
}

/**
 * Draws if anything has changed. Nothing is drawn while the world and the eye stand still.
 *
 * @param {number} now milliseconds
 */
function turn(now) {
  requestAnimationFrame(turn);
  if (hasDrawn && chooser.pictureTook(now - lastTurn)) {
    view.setQuality(chooser.quality);
    stale = true;
  }
  const seconds = Math.min(0.2, (now - lastTurn) / 1000);
  const here = room();
  const isLive = here === 'field' && cursor.shown(state).tense === 'live' && chooser.quality.smooth && smoothing.isMoving(now);
  const isReplayed = here === 'replay' && rooms.replay?.turn(seconds);
  hasDrawn = (here === 'field' || here === 'replay') && (stale || isLive || isReplayed === true);
  if (hasDrawn) {
    drawPicture(now, seconds);
  } else if (here === 'motion') {
    rooms.motion?.turn(seconds);
  } else if (here === 'robot') {
    rooms.robot?.turn(cursor.shown(state), cursor, now);
  }
  panels.turn(now);
  lastTurn = now;
  if (owesAnswer) {
    owesAnswer = false;
    send({ do: 'seen' });
  }
}

/**
 * @param {number} now milliseconds
 * @param {number} seconds since the last turn
 */
function drawPicture(now, seconds) {
  stale = false;
  const recorded = room() === 'replay' ? rooms.replay?.picture : undefined;
  if (recorded) {
    cursor.goToRecorded(recorded);
  }
  const { tense, scene, frame } = cursor.shown(state);
  if (scene && scene !== pictured) {
    pictured = scene;
    view.setScene(scene);
    desk.setScene(scene);
  }
  const picture = tense === 'live' && chooser.quality.smooth ? smoothing.picture(now) : frame;
  if (picture && picture.robots.length === scene?.robots.length) {
    view.update(picture);
  }
  stale = desk.update(view.crowd.poses, seconds);
  view.light.shine(desk.shown.target, view.camera.position);
  view.draw();
  panels.ask();
}

/** @param {number} now milliseconds */
function drawPanels(now) {
  const { tense, scene, frame } = cursor.shown(state);
  const shown = tense === 'live' ? state : { ...state, scene, frame: frame && { ...frame, paused: state.frame?.paused ?? false, speed: state.frame?.speed ?? 1 }, goal: undefined };
  draws.forEach((draw) => draw(shown, now));
  drawTimeLine(tense, room() === 'replay');
}

setInterval(() => {
  connection.checkSilence();
  drawPanels(performance.now());
}, 500);
if (token !== '') {
  connection.open();
}
requestAnimationFrame(turn);

/** What tests and the curious ask for in the browser's console. */
Object.assign(window, {
  studio: {
    get state() {
      return state;
    },
    view,
    desk,
    chooser,
    cursor,
    get motion() {
      return rooms.motion;
    },
    get robot() {
      return rooms.robot;
    },
    get replay() {
      return rooms.replay;
    },
  },
});
