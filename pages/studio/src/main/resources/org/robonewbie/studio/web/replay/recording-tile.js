/** Card of one recording, with its actions. */
import { shape } from '../panels/drawing.js';
import { button, element, setText } from '../panels/elements.js';
import { pitchSheet } from '../panels/pitch-sheet.js';
import { clock } from '../state/studio-state.js';

/**
 * @typedef {import('./recording-api.js').RecordingEntry} RecordingEntry
 * @typedef {import('./recording-api.js').RecordingCard} RecordingCard
 *
 * @typedef {object} TileActions
 * @property {() => void} open
 * @property {(on: boolean) => void} star
 * @property {(to: string) => void} rename
 * @property {() => void} remove
 */

const CYCLES_PER_SECOND = 50;
const SIDES = ['', 'left', 'right'];

/** @type {Record<string, [one: string, more: string]>} */
const EVENTS = { goal: ['goal', 'goals'], fall: ['fall', 'falls'], foul: ['foul', 'fouls'] };

export class RecordingTile {
  #picture = element('span', { class: 'recording-picture' });
  #teams = element('strong', {}, '…');
  #facts = element('span', { class: 'faint' }, '…');
  #agent = element('span', { class: 'faint' });
  #name = element('span', { class: 'faint recording-title' });
  #content = '';
  /** Number of robots, once known. @type {number | undefined} */
  #robots;

  /** @param {RecordingEntry} entry @param {TileActions} actions */
  constructor(entry, actions) {
    this.entry = entry;
    this.actions = actions;
    const { name } = entry;
    this.open = button('', `Open ${name}`, actions.open, { class: 'open' });
    this.open.append(this.#picture, this.#teams, this.#facts, this.#agent, this.#name);
    this.star = button('☆', '', () => actions.star(!this.entry.starred), { class: 'quiet star' });
    const named = (/** @type {string} */ verb) => ({ class: 'quiet', 'aria-label': `${verb} ${name}` });
    this.rename = button('Rename', `Rename ${name}`, () => this.#askName(), named('Rename'));
    this.remove = button('Delete', `Delete ${name}; Undo restores it`, actions.remove, named('Delete'));
    this.tools = element('div', { class: 'recording-tools' }, this.star, this.rename, this.remove);
    this.card = element('article', { 'data-recording': name, 'aria-label': name }, this.open, this.tools);
    this.update(entry);
  }

  /** @param {RecordingEntry} entry @returns {boolean} whether the run has ended since the last update */
  update(entry) {
    const hasEnded = this.entry.running && !entry.running;
    this.entry = entry;
    const { name, agent, starred, running, bookmarks } = entry;
    setText(this.star, starred ? '★' : '☆');
    this.star.title = starred
      ? `${name} is kept. Click to remove the star`
      : `Star ${name} to keep it when old recordings are removed`;
    this.star.setAttribute('aria-pressed', String(starred));
    this.star.setAttribute('aria-label', `Star of ${name}`);
    const marks = bookmarks.length === 1 ? '1 bookmark' : `${bookmarks.length} bookmarks`;
    setText(this.#agent, [agent, bookmarks.length > 0 ? marks : ''].filter(Boolean).join(' · '));
    this.remove.hidden = running;
    setText(this.#name, running ? `${name} · now` : name);
    return hasEnded;
  }

  /** @param {RecordingCard | undefined} content undefined if it is unreadable */
  fill(content) {
    if (!content) {
      setText(this.#teams, 'cannot be read');
      setText(this.#facts, '');
      return;
    }
    const { left, right, score, count, robots } = content;
    const title = left && right ? `${left} ${score.join(' : ')} ${right}` : left || right || 'no robot';
    const events = Object.entries(EVENTS).flatMap(([kind, names]) => counted(content.events, kind, names));
    this.#robots = robots;
    setText(this.#teams, title);
    setText(
      this.#facts,
      [clock(count / CYCLES_PER_SECOND), robots === 1 ? '1 robot' : `${robots} robots`, ...events].join(' · '),
    );
    this.#picture.replaceChildren(smallPitch(content));
    this.#content = `${title} ${events.join(' ')}`;
  }

  /** @param {string} wanted search text in lower case @param {string} filter @returns {boolean} whether the card matches */
  fits(wanted, filter) {
    const { name, agent, starred, ofProject, running, bookmarks } = this.entry;
    const notes = bookmarks.map(({ note }) => note).join(' ');
    const isEmpty = this.#robots === 0 && !running;
    const isOfKind = { project: ofProject && !isEmpty, starred, empty: isEmpty }[filter] ?? (!isEmpty || starred);
    return isOfKind && `${name} ${agent} ${notes} ${this.#content}`.toLowerCase().includes(wanted);
  }

  #askName() {
    const field = element('input', { 'aria-label': 'New name', value: this.entry.name, maxlength: '80' });
    let isOpen = true;
    const end = () => {
      if (isOpen) {
        isOpen = false;
        field.replaceWith(this.tools);
      }
    };
    field.addEventListener('keydown', (event) => {
      const name = field.value.trim();
      if (event.key === 'Enter' || event.key === 'Escape') {
        event.stopPropagation();
        end();
        this.rename.focus();
      }
      if (event.key === 'Enter' && name !== '') {
        this.actions.rename(name);
      }
    });
    field.addEventListener('blur', end);
    this.tools.replaceWith(field);
    field.select();
  }
}

/** @param {ReadonlyArray<{kind: string}>} events @param {string} kind @param {[one: string, more: string]} names */
function counted(events, kind, [one, more]) {
  const count = events.filter((event) => event.kind === kind).length;
  return count === 0 ? [] : [`${count} ${count === 1 ? one : more}`];
}

/** @param {RecordingCard} content */
function smallPitch({ pitch: [length, width], ball, ways }) {
  const path = (/** @type {Array<[number, number]>} */ places, /** @type {string} */ kind) =>
    shape('polyline', { points: places.map(([px, py]) => `${px},${-py}`).join(' '), class: `way ${kind}` });
  const dot = (/** @type {Array<[number, number]>} */ places, /** @type {number} */ r, /** @type {string} */ kind) => {
    const [cx, cy] = places.at(-1) ?? [0, 0];
    return shape('circle', { cx, cy: -cy, r, class: kind });
  };
  return pitchSheet(
    length,
    width,
    ...ways.map(({ places, side }) => path(places, SIDES[side])),
    path(ball, 'ball'),
    ...ways.map(({ places, side }) => dot(places, length / 55, SIDES[side])),
    dot(ball, length / 80, 'ball'),
  );
}
