/** The room in which runs are seen again: recordings, the time line, and what the picture of the field shows of them. */
import { button, byId, element, setText } from '../panels/elements.js';
import { advanced, atMoment, BEGINNING, csvOf, frameOf, looped, MOMENTS_PER_SECOND, neighbourEvent, sceneOf, stepped } from '../state/replay/replay-state.js';
import { startFrom } from '../panels/scene-panel.js';
import { NO_CLOCK } from '../panels/transport.js';
import { ComparisonPanel } from './comparison-panel.js';
import { eventText, ReplayLine } from './replay-line.js';
import { listRecordings, loadLog, loadModels, RecordingFile } from './recordings.js';

/**
 * @typedef {import('../state/replay/replay-state.js').ReplayState} ReplayState
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../live/state-frame.js').Frame} Frame
 * @typedef {{token: string, note: (text: string) => void, goLive: () => void, hasClock: () => boolean}} Surroundings
 */

const LIST_MILLISECONDS = 3000;
const BEHIND_MOMENTS = 100;
const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8];

/** @param {Surroundings} surroundings */
export async function openReplayRoom(surroundings) {
  const room = new ReplayRoom(surroundings, await loadModels(surroundings.token));
  await room.refresh();
  return room;
}

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
    this.comparison = new ComparisonPanel(surroundings.token, models, { note: surroundings.note, changed: () => this.#set(this.state) });
    this.draw = this.#panel(byId('replay'));
    setInterval(() => {
      if (!byId('replay').hidden && !document.hidden) {
        this.refresh().catch(() => {});
      }
    }, LIST_MILLISECONDS);
  }

  /** Looks which recordings there are, and opens the newest if none is open. */
  async refresh() {
    const { recordings } = await listRecordings(this.surroundings.token);
    this.list = recordings;
    if (!this.file && recordings.length > 0) {
      const wanted = decodeURIComponent(location.hash.split('/')[1] ?? '');
      this.choose(recordings.find(({ name }) => name === wanted)?.name ?? recordings[0].name);
    }
    this.stale = true;
  }

  /** @param {string} name */
  choose(name) {
    this.file?.close();
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
    const roster = moment.robots;
    if (!this.scene || this.roster !== roster || this.scene.teams.left !== moment.game.left || this.scene.teams.right !== moment.game.right || this.scene.playModes[0] !== moment.game.playMode) {
      this.revision = this.roster === roster ? this.revision : this.revision + 1;
      this.roster = roster;
      this.scene = sceneOf(moment, this.file.reader.header, this.models, this.revision);
    }
    const seen = this.comparison.picture({ scene: this.scene, frame: frameOf(moment, this.scene) }, this.state.index);
    return { ...seen, name: this.file.name, reader: this.file.reader, running: this.isRunning };
  }

  /** What keys do here. */
  get deeds() {
    const deed = (/** @type {string[]} */ keys, /** @type {string} */ shown, /** @type {string} */ text, /** @type {() => void} */ act) => ({ keys, shown, text, act });
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
    const atEnd = index >= count - 1 - BEHIND_MOMENTS && !this.state.playing && count > 0;
    const follows = atEnd && this.list.find(({ name }) => name === this.file?.name)?.running;
    this.#set({ ...this.state, count: moments, index: follows ? Math.max(0, moments - 1) : index });
    if (this.file?.problem && moments === 0) {
      this.surroundings.note(this.file.problem);
    }
  }

  /** @param {-1 | 1} direction */
  #jump(direction) {
    const event = neighbourEvent(this.state, (this.file?.events ?? []).filter(({ kind }) => kind !== 'log'), direction);
    if (event) {
      this.#set({ ...atMoment(this.state, Math.max(0, event.index)), playing: false });
      this.surroundings.note(eventText(event));
    }
  }

  /** @param {HTMLElement} place */
  #panel(place) {
    const act = (/** @type {string} */ shown) => this.deeds.find((deed) => deed.shown === shown)?.act;
    const play = button('', 'Play or pause (space)', () => act('Space')?.());
    play.className = 'primary';
    play.id = 'replay-play';
    const make = (/** @type {string} */ id, /** @type {string} */ name, /** @type {string} */ hint, /** @type {string} */ key) => {
      const made = button(name, `${hint} (${key})`, () => act(key)?.());
      made.id = id;
      return made;
    };
    const loop = make('replay-loop', 'Loop', 'Repeat two seconds around this moment', 'L');
    const recording = element('select', { id: 'recording', 'aria-label': 'Recording' });
    recording.addEventListener('change', () => this.choose(recording.value));
    const speed = element('select', { id: 'replay-speed', 'aria-label': 'Speed of the replay' });
    speed.append(...SPEEDS.map((each) => element('option', { value: String(each) }, `${each}×`)));
    speed.addEventListener('change', () => this.#set({ ...this.state, speed: Number(speed.value) }));
    const reading = element('span', { class: 'seconds' });
    const csv = button('CSV', 'Save all cycles as a table', () => this.#offer('csv', csvOf(this.file?.reader.moments ?? [], this.models)));
    csv.id = 'export-csv';
    const log = button('Log', 'Save the run as the log of a SimSpark server, for RoboViz', () => this.#offerLog());
    log.id = 'export-log';
    const page = button('HTML', 'Save one file that plays this run in any browser, without network', () => this.#offerPage());
    page.id = 'export-html';
    const start = button('Start here', '', () => this.#startHere());
    start.id = 'start-here';
    const line = element('div', { class: 'replay-line', id: 'replay-line', title: 'Drag to any moment' });
    const drawing = new ReplayLine(line, (index) => this.#set({ ...atMoment(this.state, index), playing: false }));
    place.append(
      this.comparison.svg,
      line,
      element(
        'div',
        { class: 'replay-bar' },
        recording,
        make('event-before', '|◂', 'Event before', '['),
        make('replay-back', '◂', 'One cycle back', '←'),
        play,
        make('replay-on', '▸', 'One cycle on', '→'),
        make('event-next', '▸|', 'Next event', ']'),
        loop,
        start,
        speed,
        reading,
        this.comparison.choice,
        this.comparison.reading,
        element('span', { class: 'replay-export' }, csv, log, page),
      ),
    );
    let listed = '';
    return () => {
      const { state, list } = this;
      const names = JSON.stringify(list);
      if (names !== listed) {
        listed = names;
        recording.replaceChildren(...list.map(({ name, bytes, running }) => element('option', { value: name }, `${name} · ${running ? 'now' : `${(bytes / 1e6).toFixed(1)} MB`}`)));
      }
      recording.value = this.file?.name ?? '';
      recording.hidden = list.length === 0;
      setText(play, state.playing ? '❚❚ Pause' : '▶ Play');
      loop.setAttribute('aria-pressed', String(state.loop !== undefined));
      speed.value = String(state.speed);
      const seconds = (/** @type {number} */ index) => (Math.max(0, index) / MOMENTS_PER_SECOND).toFixed(2);
      setText(reading, list.length === 0 ? 'Nothing is recorded yet.' : `${seconds(state.index)} of ${seconds(state.count - 1)} s`);
      play.disabled = state.count === 0;
      const hasClock = this.surroundings.hasClock();
      start.disabled = state.count === 0 || !hasClock;
      start.title = hasClock ? 'The simulation goes on from this moment, with the clock stopped; puppets stand in for missing robots' : NO_CLOCK;
      for (const control of [csv, log, page]) {
        control.disabled = state.count === 0 || !this.file?.isWhole;
      }
      this.comparison.list(list, this.file?.name ?? '');
      this.comparison.draw(this.file?.reader.moments ?? []);
      drawing.draw(state, this.file?.events ?? []);
    };
  }

  async #startHere() {
    this.#set({ ...this.state, playing: false });
    try {
      await startFrom(this.surroundings.token, this.file?.name ?? '', Math.round(this.state.index));
      location.hash = '#field';
      this.surroundings.goLive();
      this.surroundings.note('The clock stands at this moment. Press play to go on from here.');
    } catch (error) {
      this.surroundings.note(/** @type {Error} */ (error).message);
    }
  }

  async #offerLog() {
    try {
      this.#offer('log.gz', await loadLog(this.surroundings.token, this.file?.name ?? ''));
    } catch (error) {
      this.surroundings.note(`The file cannot be made: ${/** @type {Error} */ (error).message}`);
    }
  }

  async #offerPage() {
    try {
      const { standalonePage } = await import('./standalone.js');
      this.#offer('html', await standalonePage(this.file?.packed ?? [], this.models, this.file?.name ?? ''));
    } catch (error) {
      this.surroundings.note(`The file cannot be made: ${/** @type {Error} */ (error).message}`);
    }
  }

  /** @param {string} ending @param {string | Blob} content */
  #offer(ending, content) {
    const address = URL.createObjectURL(typeof content === 'string' ? new Blob([content], { type: ending === 'csv' ? 'text/csv' : 'text/html' }) : content);
    element('a', { href: address, download: `${this.file?.name ?? 'run'}.${ending}` }).click();
    setTimeout(() => URL.revokeObjectURL(address), 20_000);
  }
}
