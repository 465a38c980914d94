/** Playback controls below the 3D view of a replay. */
import { button, byId, choice, element, setText } from '../panels/elements.js';
import { NO_CLOCK } from '../panels/transport.js';
import { MOMENTS_PER_SECOND } from '../state/replay/replay-state.js';
import { legend, ReplayLine } from './replay-line.js';

/**
 * @typedef {import('../state/replay/replay-state.js').ReplayState} ReplayState
 * @typedef {import('./recording-api.js').RecordingEntry} RecordingEntry
 *
 * @typedef {object} Actions
 * @property {(key: string) => void} press performs the action of a key
 * @property {() => void} showRecordings shows the list of recordings
 * @property {(speed: number) => void} setSpeed
 * @property {(index: number) => void} goTo
 * @property {() => void} startHere
 * @property {Record<'csv' | 'log' | 'html' | 'video', () => void>} save
 *
 * @typedef {object} Shown
 * @property {ReplayState} state
 * @property {readonly RecordingEntry[]} list
 * @property {import('./recordings.js').RecordingFile | undefined} file
 * @property {boolean} hasClock whether the simulation can continue from here
 */

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8];
const START_HINT = 'Starts a simulation from this moment, paused; puppets stand in for robots without a program';

export class ReplayBar {
  /**
   * @param {HTMLElement} place
   * @param {import('./comparison-panel.js').ComparisonPanel} comparison
   * @param {import('./bookmark-list.js').BookmarkList} bookmarks
   * @param {Actions} actions
   */
  constructor(place, comparison, bookmarks, actions) {
    this.actions = actions;
    /** Buttons that need an open recording. @type {HTMLButtonElement[]} */
    this.keys = [];
    this.play = this.#key('replay-play', '', 'Play or pause', 'Space');
    this.play.className = 'primary';
    this.loop = this.#key('replay-loop', 'Loop', 'Loop two seconds around this moment', 'L');
    this.recording = button('Recordings', 'Choose another recording', actions.showRecordings, { id: 'recording' });
    this.speed = choice(
      { id: 'replay-speed', 'aria-label': 'Speed of the replay' },
      SPEEDS.map((each) => [String(each), `${each}×`]),
      (speed) => actions.setSpeed(Number(speed)),
    );
    this.reading = element('span', { class: 'seconds' });
    this.name = element('span', { class: 'faint', id: 'recording-name' });
    this.start = button('Start here', '', actions.startHere, { id: 'start-here' });
    this.saves = saveButtons(actions.save);
    const line = element('div', { class: 'replay-line', id: 'replay-line', title: 'Drag to any moment' });
    this.line = new ReplayLine(line, actions.goTo);
    place.append(comparison.line, line, legend(), this.#bar(comparison, bookmarks));
  }

  /** @param {Shown} shown */
  draw({ state, list, file, hasClock }) {
    setText(this.name, file?.name ?? '');
    setText(this.play, state.playing ? '❚❚ Pause' : '▶ Play');
    this.loop.setAttribute('aria-pressed', String(state.loop !== undefined));
    this.speed.value = String(state.speed);
    const nothing = list.length === 0 ? 'Nothing has been recorded yet.' : 'Choose a recording.';
    setText(this.reading, file ? readingOf(state) : nothing);
    for (const control of this.keys) {
      control.disabled = state.count === 0;
    }
    this.start.disabled = state.count === 0 || !hasClock;
    this.start.title = hasClock ? START_HINT : NO_CLOCK;
    for (const control of this.saves) {
      control.disabled = state.count === 0 || !file?.isWhole;
    }
    byId('export-log').hidden = file !== undefined && !file.isOfNaos;
    this.line.draw(state, file?.events ?? []);
  }

  /** @param {import('./comparison-panel.js').ComparisonPanel} comparison @param {import('./bookmark-list.js').BookmarkList} bookmarks */
  #bar(comparison, bookmarks) {
    return element(
      'div',
      { class: 'replay-bar' },
      this.recording,
      this.name,
      this.#sign('event-before', '|◂', 'Previous event', '['),
      this.#sign('replay-back', '◂', 'One cycle back', '←'),
      this.play,
      this.#sign('replay-on', '▸', 'One cycle forward', '→'),
      this.#sign('event-next', '▸|', 'Next event', ']'),
      this.loop,
      bookmarks.element,
      this.start,
      this.speed,
      this.reading,
      comparison.choice,
      element('span', { class: 'replay-export' }, ...this.saves),
    );
  }

  /**
   * Creates a button that performs the action of a key.
   *
   * @param {string} id @param {string} name @param {string} hint @param {string} key
   */
  #key(id, name, hint, key) {
    const made = button(name, `${hint} (${key})`, () => this.actions.press(key), { id });
    this.keys.push(made);
    return made;
  }

  /**
   * Creates a button that performs the action of a key and shows a symbol. @param {string} id @param {string} sign @param {string} hint
   * @param {string} key
   */
  #sign(id, sign, hint, key) {
    const made = this.#key(id, sign, hint, key);
    made.ariaLabel = hint;
    return made;
  }
}

/** @param {Actions['save']} save */
function saveButtons(save) {
  return [
    button('CSV', 'Save all cycles, or only the loop, as a table', save.csv, { id: 'export-csv' }),
    button('Log', 'Save the run as a SimSpark server log, for RoboViz', save.log, { id: 'export-log' }),
    button('HTML', 'Save a file that plays this run, or only the loop, in any browser, even offline', save.html, {
      id: 'export-html',
    }),
    button('Video', 'Save a video (WebM, 720p) of this run, or only of the loop, as this camera shows it', save.video, {
      id: 'export-video',
    }),
  ];
}

/** @param {ReplayState} state */
function readingOf({ index, count }) {
  const seconds = (/** @type {number} */ at) => (Math.max(0, at) / MOMENTS_PER_SECOND).toFixed(2);
  return `${seconds(index)} of ${seconds(count - 1)} s`;
}
