/** The room in which runs are seen again: recordings, the time line, and what the picture of the field shows of them. */
import { byId, offer } from '../panels/elements.js';
import {
  advanced,
  atMoment,
  BEGINNING,
  csvOf,
  frameOf,
  looped,
  MOMENTS_PER_SECOND,
  neighbourEvent,
  sceneOf,
  stepped,
} from '../state/replay/replay-state.js';
import { restoredText, startFrom } from '../panels/scene-panel.js';
import { ComparisonPanel } from './comparison-panel.js';
import { ReplayBar } from './replay-bar.js';
import { RecordingShelf } from './recording-shelf.js';
import { eventText } from './replay-line.js';
import { listRecordings, loadLog, loadModels, RecordingFile } from './recordings.js';

/**
 * @typedef {import('../state/replay/replay-state.js').ReplayState} ReplayState
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../live/state-frame.js').Frame} Frame
 * @typedef {{token: string, note: (text: string) => void, goLive: () => void, hasClock: () => boolean}} Surroundings
 */

const LIST_MILLISECONDS = 3000;
const BEHIND_MOMENTS = 100;

/** @type {Record<string, string>} */
const TYPES = { csv: 'text/csv', html: 'text/html' };

/** @param {Surroundings} surroundings */
export async function openReplayRoom(surroundings) {
  const room = new ReplayRoom(surroundings, await loadModels(surroundings.token));
  await room.refresh();
  return room;
}

/** @param {string[]} keys @param {string} shown @param {string} text @param {() => void} act */
const deed = (keys, shown, text, act) => ({ keys, shown, text, act });

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
    /** @type {import('./recordings.js').RecordingEntry[]} */
    this.list = [];
    /** @type {Scene | undefined} */
    this.scene = undefined;
    this.stale = true;
    this.revision = 0;
    /** @type {object | undefined} */
    this.roster = undefined;
    this.comparison = new ComparisonPanel(surroundings.token, models, {
      note: surroundings.note,
      changed: () => this.#set(this.state),
    });
    this.shelf = new RecordingShelf(surroundings.token, (name) => this.choose(name));
    this.bar = this.#bar();
    setInterval(() => {
      if (!byId('replay').hidden && !document.hidden) {
        this.refresh().catch(() => {});
      }
    }, LIST_MILLISECONDS);
  }

  /** Looks which recordings there are, and opens the one that the address names. */
  async refresh() {
    const { recordings } = await listRecordings(this.surroundings.token);
    this.list = recordings;
    this.shelf.list(recordings);
    const wanted = decodeURIComponent(location.hash.split('/')[1] ?? '');
    if (!this.file && recordings.some(({ name }) => name === wanted)) {
      this.choose(wanted);
    }
    this.shelf.show(this.shelf.isOpen || !this.file);
    this.stale = true;
  }

  /** @param {string} name */
  choose(name) {
    this.file?.close();
    this.shelf.show(false);
    const entry = this.list.find((each) => each.name === name);
    const file = new RecordingFile(this.surroundings.token, name, this.models, () => this.#grow());
    this.file = file;
    this.state = { ...BEGINNING, speed: this.state.speed };
    file.load(entry?.running ?? false).catch((error) => this.surroundings.note(error.message));
  }

  /**
   * Moves on.
   *
   * @param {number} seconds since the last turn
   * @returns {boolean} whether the picture must be drawn again
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

  /** Shows a cycle of the running simulation, if its recording is open. @param {number} cycle */
  showRunning(cycle) {
    const index = this.isRunning ? (this.file?.reader.moments.findIndex((moment) => moment.cycle >= cycle) ?? -1) : -1;
    if (index >= 0) {
      this.#set({ ...atMoment(this.state, index), playing: false });
    }
  }

  /** @returns {import('../state/time-cursor.js').RecordedMoment | undefined} what the picture shows */
  get picture() {
    const moment = this.file?.reader.moments[Math.round(this.state.index)];
    if (!moment || !this.file) {
      return undefined;
    }
    const scene = this.#sceneAt(moment, this.file.reader.header);
    const seen = this.comparison.picture({ scene, frame: frameOf(moment, scene) }, this.state.index);
    const { name, reader, drawings } = this.file;
    return { ...seen, name, reader, drawings, running: this.isRunning };
  }

  /**
   * The scene changes only with the robots, the teams and the play mode, since a new one costs a new picture.
   *
   * @param {import('../state/replay/recording-reader.js').Moment} moment
   * @param {Parameters<typeof sceneOf>[1]} header
   */
  #sceneAt(moment, header) {
    const { robots: roster, game } = moment;
    const known = this.roster === roster ? this.scene : undefined;
    const { teams, playModes } = known ?? { teams: { left: '', right: '' }, playModes: [] };
    if (known && teams.left === game.left && teams.right === game.right && playModes[0] === game.playMode) {
      return known;
    }
    this.revision += this.roster === roster ? 0 : 1;
    this.roster = roster;
    this.scene = sceneOf(moment, header, this.models, this.revision);
    return this.scene;
  }

  /** What keys do here. */
  get deeds() {
    return [
      deed([' '], 'Space', 'play or pause', () => this.#set({ ...this.#restarted(), playing: !this.state.playing })),
      deed(['ArrowLeft', ','], '←', 'one cycle back', () => this.#set(stepped(this.state, -1))),
      deed(['ArrowRight', '.'], '→', 'one cycle on', () => this.#set(stepped(this.state, 1))),
      deed(['PageUp'], 'Page up', 'one second back', () => this.#set(stepped(this.state, -MOMENTS_PER_SECOND))),
      deed(['PageDown'], 'Page down', 'one second on', () => this.#set(stepped(this.state, MOMENTS_PER_SECOND))),
      deed(['Home'], 'Home', 'to the beginning', () => this.#set(atMoment(this.state, 0))),
      deed(['End'], 'End', 'to the end', () => this.#set(atMoment(this.state, this.state.count - 1))),
      deed(['['], '[', 'event before', () => this.#jump(-1)),
      deed([']'], ']', 'next event', () => this.#jump(1)),
      deed(['l', 'L'], 'L', 'repeat two seconds around this moment', () => this.#set(looped(this.state))),
    ];
  }

  #restarted() {
    return this.state.index >= this.state.count - 1 ? atMoment(this.state, 0) : this.state;
  }

  /** @param {ReplayState} state */
  #set(state) {
    this.state = state;
    this.stale = true;
  }

  #grow() {
    const { count, index } = this.state;
    const moments = this.file?.reader.moments.length ?? 0;
    const atEnd = index >= count - 1 - BEHIND_MOMENTS && !this.state.playing;
    const follows = atEnd && this.list.find(({ name }) => name === this.file?.name)?.running;
    this.#set({ ...this.state, count: moments, index: follows ? Math.max(0, moments - 1) : index });
    if (this.file?.problem && moments === 0) {
      this.surroundings.note(this.file.problem);
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
      this.#set({ ...atMoment(this.state, Math.max(0, event.index)), playing: false });
      this.surroundings.note(eventText(event));
    }
  }

  #bar() {
    return new ReplayBar(byId('replay'), this.comparison, {
      press: (key) => this.deeds.find(({ shown }) => shown === key)?.act(),
      showShelf: () => this.shelf.show(!this.shelf.isOpen),
      setSpeed: (speed) => this.#set({ ...this.state, speed }),
      goTo: (index) => this.#set({ ...atMoment(this.state, index), playing: false }),
      startHere: () => this.#startHere(),
      save: {
        csv: () => this.#save('csv', async () => csvOf(this.file?.reader.moments ?? [], this.models)),
        log: () => this.#save('log.gz', () => loadLog(this.surroundings.token, this.file?.name ?? '')),
        html: () => this.#save('html', () => this.#page()),
      },
    });
  }

  draw() {
    const { state, list, file } = this;
    const moments = file?.reader.moments ?? [];
    this.bar.draw({ state, list, file, hasClock: this.surroundings.hasClock() });
    this.comparison.list(list, file?.name ?? '');
    this.comparison.draw(moments);
  }

  async #startHere() {
    this.#set({ ...this.state, playing: false });
    try {
      const restored = await startFrom(this.surroundings.token, this.file?.name ?? '', Math.round(this.state.index));
      location.hash = '#field';
      this.surroundings.goLive();
      this.surroundings.note(`${restoredText(restored)} Press play to go on from here.`);
    } catch (error) {
      this.surroundings.note(/** @type {Error} */ (error).message);
    }
  }

  async #page() {
    const { standalonePage } = await import('./standalone.js');
    const { packed = [], name = '', pictures = [] } = this.file ?? {};
    return standalonePage({ packed, name, pictures }, this.models);
  }

  /** @param {string} ending of the file @param {() => Promise<string | Blob>} make */
  async #save(ending, make) {
    const name = this.file?.name ?? 'run';
    try {
      offer(`${name}.${ending}`, await make(), TYPES[ending]);
    } catch (error) {
      this.surroundings.note(`The file cannot be made: ${/** @type {Error} */ (error).message}`);
    }
  }
}
