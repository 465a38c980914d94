/** The recordings as cards, with their events and the paths of the ball and the robots. */
import { button, byId, choice, element, setText } from '../panels/elements.js';
import {
  attempt,
  bringBackRecording,
  deleteRecording,
  loadCard,
  renameRecording,
  starRecording,
} from './recording-api.js';
import { RecordingTile } from './recording-tile.js';

/** @typedef {import('./recording-api.js').RecordingEntry} RecordingEntry */

/** @type {Array<[value: string, text: string]>} */
const FILTERS = [
  ['', 'All runs'],
  ['project', 'From this project'],
  ['starred', 'Starred'],
  ['empty', 'Without robots'],
];

export class RecordingRepository {
  /** @type {Map<string, RecordingTile>} */
  #tiles = new Map();
  #grid = element('div', { class: 'recording-cards' });
  #nothing = element('p', { class: 'faint' });
  #search = element('input', {
    type: 'search',
    id: 'recording-search',
    placeholder: 'Team, agent, date…',
    'aria-label': 'Search recordings',
  });
  #filter = choice({ id: 'recording-filter', 'aria-label': 'Filter recordings' }, FILTERS, () => this.#applyFilter());
  #undo = button('Undo', 'Restores the last deleted recording', () => attempt(() => this.#bringBack(), this.listener), {
    id: 'recording-undo',
    hidden: '',
  });
  /** Names of deleted recordings, the most recent last. @type {string[]} */
  #deleted = [];

  /**
   * @param {object} listener
   * @param {(name: string) => void} listener.choose
   * @param {() => Promise<void>} listener.changed called when the list must be reloaded
   * @param {(from: string, to: string) => void} listener.renamed `to` is empty if the recording was deleted
   * @param {(text: string) => void} listener.note
   */
  constructor(listener) {
    this.listener = listener;
    this.place = byId('recordings');
    this.#search.addEventListener('input', () => this.#applyFilter());
    const tools = element('span', { class: 'list-tools' }, this.#undo, this.#filter, this.#search);
    const head = element('div', { class: 'list-head' }, element('h2', {}, 'Recordings'), tools);
    this.place.replaceChildren(head, this.#nothing, this.#grid);
  }

  /** @param {boolean} open */
  show(open) {
    this.place.hidden = !open;
  }

  get isOpen() {
    return !this.place.hidden;
  }

  /** @param {readonly RecordingEntry[]} entries newest first */
  list(entries) {
    const names = new Set(entries.map(({ name }) => name));
    for (const name of [...this.#tiles.keys()].filter((each) => !names.has(each))) {
      this.#tiles.get(name)?.card.remove();
      this.#tiles.delete(name);
    }
    const fresh = entries.filter(({ name }) => !this.#tiles.has(name));
    fresh.forEach((entry) => this.#tiles.set(entry.name, new RecordingTile(entry, this.#actions(entry.name))));
    const ended = entries.filter((entry) => this.#tiles.get(entry.name)?.update(entry));
    if (fresh.length > 0) {
      this.#grid.replaceChildren(
        ...entries.map(({ name }) => /** @type {RecordingTile} */ (this.#tiles.get(name)).card),
      );
    }
    this.#fetch([...fresh, ...ended].map(({ name }) => name));
    this.#applyFilter();
  }

  /** @param {string} name @returns {import('./recording-tile.js').TileActions} */
  #actions(name) {
    return {
      open: () => this.listener.choose(name),
      star: (on) => attempt(() => starRecording(name, on), this.listener),
      rename: (to) => attempt(() => this.#rename(name, to), this.listener),
      remove: () => attempt(() => this.#remove(name), this.listener),
    };
  }

  /** @param {string} from @param {string} to */
  async #rename(from, to) {
    await renameRecording(from, to);
    this.listener.renamed(from, to);
  }

  /** @param {string} name */
  async #remove(name) {
    await deleteRecording(name);
    this.#deleted.push(name);
    this.#undo.hidden = false;
    this.listener.renamed(name, '');
    this.listener.note(`“${name}” was deleted. Undo restores it for an hour.`);
  }

  async #bringBack() {
    const name = this.#deleted.pop();
    this.#undo.hidden = this.#deleted.length === 0;
    if (name) {
      await bringBackRecording(name);
      this.listener.note(`“${name}” was restored.`);
    }
  }

  /** Fetches the summaries one after the other, so that the newest come first and the server is not overloaded. @param {string[]} names */
  async #fetch(names) {
    for (const name of names) {
      const tile = this.#tiles.get(name);
      if (tile) {
        tile.fill(await loadCard(name).catch(() => undefined));
        this.#applyFilter();
      }
    }
  }

  #applyFilter() {
    const wanted = this.#search.value.trim().toLowerCase();
    const tiles = [...this.#tiles.values()];
    tiles.forEach((tile) => tile.card.toggleAttribute('hidden', !tile.fits(wanted, this.#filter.value)));
    const found = tiles.filter(({ card }) => !card.hidden).length;
    this.#nothing.hidden = found > 0;
    setText(this.#nothing, this.#tiles.size === 0 ? 'Nothing has been recorded yet.' : nothingFound(wanted));
  }
}

/** @param {string} wanted */
function nothingFound(wanted) {
  return wanted === '' ? 'No recording matches.' : `No recording matches “${wanted}”.`;
}
