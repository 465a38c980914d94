/** Page of a self-contained HTML file: plays the embedded recording without a server. */
import { CameraController } from '../field/camera-controller.js';
import { FieldView } from '../field/field-view.js';
import { PointerController } from '../field/pointer-controller.js';
import { button, byId, element, setText } from '../panels/elements.js';
import { DrawingController } from '../panels/drawing-controller.js';
import { scoreBoardPanel } from '../panels/score-board.js';
import { QUALITIES, QualityChooser, qualityRange } from '../state/quality.js';
import { RecordingReader } from '../state/replay/recording-reader.js';
import {
  advanced,
  atMoment,
  BEGINNING,
  evenly,
  frameOf,
  MOMENTS_PER_SECOND,
  sceneOf,
  stepped,
} from '../state/replay/replay-state.js';
import { DrawingMemory } from '../state/robot/drawing-memory.js';
import { initialState, withConnection, withScene, withFrame } from '../state/studio-state.js';
import { ReplayLine } from './replay-line.js';
import { unpack } from './unpack.js';

/** Moments by which keys move the time line. @type {Record<string, number>} */
const STEPS = { ArrowLeft: -1, ArrowRight: 1, PageUp: -MOMENTS_PER_SECOND, PageDown: MOMENTS_PER_SECOND };

const models = JSON.parse(byId('models').textContent ?? '{}');
const reader = new RecordingReader((type) => models[type].hinges.length);
const packed = Uint8Array.from(atob(byId('recording').textContent ?? ''), (letter) => letter.charCodeAt(0));
await unpack([packed], (part) => reader.push(part));
const { moments, events } = evenly(reader.moments, reader.events);

document.documentElement.dataset.theme = matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
const view = new FieldView(byId('stage'), QUALITIES[1]);
const chooser = new QualityChooser(qualityRange(view.graphics), false);
view.setQuality(chooser.quality);
view.setTheme(document.documentElement.dataset.theme === 'dark' ? 'dark' : 'light');
const cameraController = new CameraController(view.camera, () => view.free);
let replay = { ...BEGINNING, count: moments.length, playing: true };
let state = withConnection(initialState());
let revision = 0;
let stale = true;
let last = 0;
new PointerController(view, cameraController, {
  now: () => state,
  isSteered: () => false,
  send: () => {},
  changed: () => {
    stale = true;
  },
});
const drawings = new DrawingMemory(Infinity);
drawings.receive(JSON.parse(byId('pictures').textContent ?? '[]'));
const layers = new DrawingController(view, () => {
  stale = true;
});
const board = scoreBoardPanel();
const play = button('', '', () => {
  const isOver = replay.index >= replay.count - 1;
  replay = { ...(isOver ? atMoment(replay, 0) : replay), playing: !replay.playing };
  stale = true;
});
play.className = 'primary';
const reading = element('span', { class: 'seconds' });
const place = element('div', { class: 'replay-line' });
const line = new ReplayLine(place, (index) => {
  replay = { ...atMoment(replay, index), playing: false };
  stale = true;
});
place.addEventListener('keydown', ({ key }) => {
  if (key in STEPS) {
    replay = stepped(replay, STEPS[key]);
    stale = true;
  }
});
byId('replay').append(place, element('div', { class: 'replay-bar' }, play, reading));
addEventListener('resize', () => {
  view.resize();
  stale = true;
});
requestAnimationFrame(turn);

/** @param {number} now milliseconds */
function turn(now) {
  const seconds = Math.min(0.2, (now - last) / 1000);
  const before = replay;
  replay = advanced(replay, seconds);
  if (stale || before !== replay || replay.playing) {
    draw(now, seconds);
  } else {
    view.refine(now);
  }
  last = now;
  requestAnimationFrame(turn);
}

/** @param {number} now @param {number} seconds */
function draw(now, seconds) {
  const moment = moments[Math.round(replay.index)];
  if (!moment) {
    setText(reading, 'This recording is empty.');
    return;
  }
  const roster = state.scene?.robots !== moment.robots;
  const scene = sceneOf(moment, reader.header, models, roster ? ++revision : revision);
  if (roster) {
    view.setScene(scene);
    cameraController.setScene(scene);
  }
  state = withFrame(withScene(state, scene), frameOf(moment, scene), now);
  const frame = /** @type {import('../live/state-frame.js').Frame} */ (state.frame);
  view.update(frame);
  view.trail.follow(frame.cycle, frame.ball);
  layers.show(state, drawings);
  stale = view.look(cameraController, seconds);
  view.draw();
  board(state, now);
  line.draw(replay, events);
  setText(play, replay.playing ? '❚❚ Pause' : '▶ Play');
  const text = (/** @type {number} */ index) => (index / MOMENTS_PER_SECOND).toFixed(1);
  setText(reading, `${text(replay.index)} of ${text(replay.count - 1)} s`);
}

Object.assign(window, {
  player: {
    reader,
    view,
    get replay() {
      return replay;
    },
  },
});
