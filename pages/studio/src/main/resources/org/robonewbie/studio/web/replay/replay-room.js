/** The replay room: recordings, the time line, and the moment shown in the 3D view of the field. */
import { byId } from '../panels/elements.js';
import {
  advanced,
  atMoment,
  BEGINNING,
  frameOf,
  looped,
  MOMENTS_PER_SECOND,
  neighbourEvent,
  placeOf,
  stepped,
} from '../state/replay/replay-state.js';
import { restoredText, startFrom } from '../panels/scene-panel.js';
import { BookmarkList, momentLink } from './bookmark-list.js';
import { ComparisonPanel } from './comparison-panel.js';
import { ExportController } from './export-controller.js';
import { ReplayBar } from './replay-bar.js';
import { RecordingRepository } from './recording-repository.js';
import { SceneMemory } from './scene-memory.js';
import { eventText } from './replay-line.js';
import { listRecordings, loadModels } from './recording-api.js';
import { RecordingFile } from './recordings.js';

/**
 * @typedef {import('../state/replay/replay-state.js').ReplayState} ReplayState
 * @typedef {object} Surroundings
 * @property {(text: string) => void} note
 * @property {() => void} goLive
 * @property {() => boolean} hasClock
 * @property {() => import('../field/camera-controller.js').CameraController} camera
 */

const LIST_MILLISECONDS = 3000;
const BEHIND_MOMENTS = 100;

/** @param {Surroundings} surroundings */
export async function openReplayRoom(surroundings) {
  const room = new ReplayRoom(surroundings, await loadModels());
  await room.refresh();
  return room;
}

/** @param {string[]} keys @param {string} shown @param {string} text @param {() => void} act */
const action = (keys, shown, text, act) => ({ keys, shown, text, act });

class ReplayRoom {
  /**
   * @param {Surroundings} surroundings
   * @param {Record<string, import('../state/kinematics.js').RobotModel>} models
   */
  constructor(surroundings, models) {
    this.surroundings = surroundings;
    this.models = models;
    /** @type {ReplayState} */
    this.state = BEGINNING;
    /** @type {RecordingFile | undefined} */
    this.file = undefined;
    /** @type {import('./recording-api.js').RecordingEntry[]} */
    this.list = [];
    this.stale = true;
    this.scenes = new SceneMemory(models);
    /** The moment to show as soon as it has been loaded. @type {{index: number, playing: boolean} | undefined} */
    this.wanted = undefined;
    this.comparison = new ComparisonPanel(models, {
      note: surroundings.note,
      changed: () => this.#set(this.state),
    });
    this.repository = new RecordingRepository({
      choose: (name) => this.choose(name),
      changed: () => this.refresh(),
      renamed: (from, to) => this.#renamed(from, to),
      note: surroundings.note,
    });
    this.bookmarks = this.#bookmarkList();
    this.exports = new ExportController({
      models,
      note: surroundings.note,
      file: () => this.file,
      section: () => this.#section(),
      camera: surroundings.camera,
    });
    this.bar = this.#bar();
    addEventListener('hashchange', () => this.#followAddress());
    setInterval(() => {
      if (!byId('replay').hidden && !document.hidden) {
        this.refresh().catch(() => {});
      }
    }, LIST_MILLISECONDS);
  }

  /** Reloads the list of recordings, and opens the one specified in the address. */
  async refresh() {
    const { recordings } = await listRecordings();
    this.list = recordings;
    this.repository.list(recordings);
    if (!this.file) {
      this.#followAddress();
    }
    this.repository.show(this.repository.isOpen || !this.file);
    this.stale = true;
  }

  /** Opens the recording specified in the address, paused at the given moment or playing. */
  #followAddress() {
    const { name, seconds, plays } = placeOf(location.hash);
    const isHere = location.hash.startsWith('#replay/') && this.list.some((each) => each.name === name);
    if (isHere && this.file?.name !== name) {
      this.choose(name);
    }
    if (isHere && (plays || seconds !== undefined)) {
      this.wanted = { index: (seconds ?? 0) * MOMENTS_PER_SECOND, playing: plays };
      this.#grow();
    }
  }

  /** Updates the room after the open recording has been renamed or deleted. @param {string} from @param {string} to */
  #renamed(from, to) {
    if (this.file?.name === from) {
      this.file.close();
      this.file = undefined;
      this.state = BEGINNING;
      this.surroundings.goLive();
      history.replaceState(undefined, '', to === '' ? '#replay' : momentLink(to, 0));
    }
  }

  /** @param {string} name */
  choose(name) {
    this.file?.close();
    this.repository.show(false);
    this.wanted = undefined;
    if (placeOf(location.hash).name !== name) {
      history.replaceState(undefined, '', `#replay/${encodeURIComponent(name)}`);
    }
    const entry = this.list.find((each) => each.name === name);
    const file = new RecordingFile(name, this.models, () => this.#grow());
    this.file = file;
    this.state = { ...BEGINNING, speed: this.state.speed };
    file.load(entry?.running ?? false).catch((error) => this.surroundings.note(error.message));
  }

  /**
   * Advances the playback.
   *
   * @param {number} seconds since the last call
   * @returns {boolean} whether the picture must be redrawn
   */
  turn(seconds) {
    const before = this.state;
    this.state = advanced(this.state, seconds);
    const changed = this.stale || before.index !== this.state.index;
    this.stale = false;
    if (changed) {
      this.draw();
    }
    return changed;
  }

  /** @returns {boolean} whether the recording of the running simulation is open */
  get isRunning() {
    return this.list.some(({ name, running }) => running && name === this.file?.name);
  }

  /** Shows a cycle of the running simulation if its recording is open. @param {number} cycle */
  showRunning(cycle) {
    const index = cycle - (this.file?.run.firstCycle ?? 0);
    if (this.isRunning && index >= 0) {
      this.#goTo(index);
    }
  }

  /** @returns {import('../state/time-cursor.js').RecordedMoment | undefined} the displayed moment */
  get picture() {
    const moment = this.file?.run.at(Math.round(this.state.index));
    if (!moment || !this.file) {
      return undefined;
    }
    const scene = this.scenes.at(moment, this.file.run.header);
    const seen = this.comparison.picture({ scene, frame: frameOf(moment, scene) }, this.state.index);
    const { name, run, drawings } = this.file;
    return { ...seen, name, run, drawings, running: this.isRunning };
  }

  /** Key actions of this room. */
  get actions() {
    return [
      action([' '], 'Space', 'play or pause', () => this.#set({ ...this.#restarted(), playing: !this.state.playing })),
      action(['ArrowLeft', ','], '←', 'one cycle back', () => this.#set(stepped(this.state, -1))),
      action(['ArrowRight', '.'], '→', 'one cycle forward', () => this.#set(stepped(this.state, 1))),
      action(['PageUp'], 'Page up', 'one second back', () => this.#set(stepped(this.state, -MOMENTS_PER_SECOND))),
      action(['PageDown'], 'Page down', 'one second forward', () => this.#set(stepped(this.state, MOMENTS_PER_SECOND))),
      action(['Home'], 'Home', 'to the beginning', () => this.#set(atMoment(this.state, 0))),
      action(['End'], 'End', 'to the end', () => this.#set(atMoment(this.state, this.state.count - 1))),
      action(['['], '[', 'previous event', () => this.#jump(-1)),
      action([']'], ']', 'next event', () => this.#jump(1)),
      action(['m', 'M'], 'M', 'set a bookmark', () => this.bookmarks.ask()),
      action(['l', 'L'], 'L', 'loop two seconds around this moment', () => this.#set(looped(this.state))),
    ];
  }

  #restarted() {
    return this.state.index >= this.state.count - 1 ? atMoment(this.state, 0) : this.state;
  }

  /** @param {number} index index of the moment at which to pause */
  #goTo(index) {
    this.#set({ ...atMoment(this.state, index), playing: false });
  }

  /** @param {ReplayState} state */
  #set(state) {
    this.state = state;
    this.stale = true;
  }

  #grow() {
    const { count, index } = this.state;
    const moments = this.file?.run.count ?? 0;
    const atEnd = index >= count - 1 - BEHIND_MOMENTS && !this.state.playing;
    const follows = atEnd && this.list.find(({ name }) => name === this.file?.name)?.running;
    this.#set({ ...this.state, count: moments, index: follows ? Math.max(0, moments - 1) : index });
    const { wanted } = this;
    if (wanted && wanted.index < moments && (this.file?.isWhole || !wanted.playing)) {
      this.#set({ ...atMoment(this.state, wanted.index), playing: wanted.playing });
      this.wanted = undefined;
    }
  }

  /** @param {-1 | 1} direction */
  #jump(direction) {
    const event = neighbourEvent(
      this.state,
      (this.file?.events ?? []).filter(({ kind }) => kind !== 'log'),
      direction,
    );
    if (event) {
      this.#goTo(event.index);
      this.surroundings.note(eventText(event));
    }
  }

  #bookmarkList() {
    return new BookmarkList({
      now: () => this.state.index,
      goTo: (index) => this.#goTo(index),
      changed: () => this.refresh(),
      note: this.surroundings.note,
    });
  }

  #bar() {
    return new ReplayBar(byId('replay'), this.comparison, this.bookmarks, {
      press: (key) => this.actions.find(({ shown }) => shown === key)?.act(),
      showRecordings: () => this.repository.show(!this.repository.isOpen),
      setSpeed: (speed) => this.#set({ ...this.state, speed }),
      goTo: (index) => this.#goTo(index),
      startHere: () => this.#startHere(),
      save: this.exports.actions,
    });
  }

  draw() {
    const { state, list, file } = this;
    this.bookmarks.draw(file?.name ?? '', list.find(({ name }) => name === file?.name)?.bookmarks ?? []);
    this.bar.draw({ state, list, file, hasClock: this.surroundings.hasClock() });
    this.comparison.list(list, file?.name ?? '');
    this.comparison.draw(file?.run);
  }

  async #startHere() {
    this.#set({ ...this.state, playing: false });
    try {
      const restored = await startFrom(this.file?.name ?? '', Math.round(this.state.index));
      location.hash = '#field';
      this.surroundings.goLive();
      this.surroundings.note(`${restoredText(restored)} Press play to continue from here.`);
    } catch (error) {
      this.surroundings.note(/** @type {Error} */ (error).message);
    }
  }

  /** Returns the section to export: the one that is being repeated, or the whole recording. @returns {import('./exports.js').Section} */
  #section() {
    const [from, to] = this.state.loop ?? [0, this.state.count - 1];
    return [Math.round(from), Math.round(to)];
  }
}
