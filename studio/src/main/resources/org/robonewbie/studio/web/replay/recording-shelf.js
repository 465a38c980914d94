/** The recordings as cards: what happened in each, and where everybody stood at its end. */
import { shape } from '../panels/drawing.js';
import { button, byId, element, setText } from '../panels/elements.js';
import { clock } from '../state/studio-state.js';
import { loadCard } from './recordings.js';

/**
 * @typedef {import('./recordings.js').RecordingEntry} RecordingEntry
 * @typedef {import('./recordings.js').RecordingCard} RecordingCard
 * @typedef {{card: HTMLButtonElement, picture: HTMLElement, teams: HTMLElement, facts: HTMLElement, words: string}} Drawn
 */

const SIDES = ['left', 'right'];

/** @type {Record<string, [one: string, more: string]>} */
const EVENTS = { goal: ['goal', 'goals'], fall: ['fall', 'falls'], foul: ['foul', 'fouls'] };

export class RecordingShelf {
  /** @type {Map<string, Drawn>} */
  #cards = new Map();
  #grid = element('div', { class: 'recording-cards' });
  #nothing = element('p', { class: 'faint' });
  #search = element('input', {
    type: 'search',
    id: 'recording-search',
    placeholder: 'Search: team, date…',
    'aria-label': 'Search recordings',
  });

  /** @param {string} token @param {(name: string) => void} choose */
  constructor(token, choose) {
    this.token = token;
    this.choose = choose;
    this.place = byId('recordings');
    this.#search.addEventListener('input', () => this.#sift());
    const head = element('div', { class: 'list-head' }, element('h2', {}, 'Recordings'), this.#search);
    this.place.append(head, this.#nothing, this.#grid);
  }

  /** @param {boolean} open */
  show(open) {
    this.place.hidden = !open;
  }

  get isOpen() {
    return !this.place.hidden;
  }

  /** @param {readonly RecordingEntry[]} entries the newest first */
  list(entries) {
    const names = new Set(entries.map(({ name }) => name));
    for (const name of [...this.#cards.keys()].filter((each) => !names.has(each))) {
      this.#cards.get(name)?.card.remove();
      this.#cards.delete(name);
    }
    const fresh = entries.filter(({ name }) => !this.#cards.has(name));
    fresh.forEach((entry) => this.#cards.set(entry.name, this.#empty(entry)));
    if (fresh.length > 0) {
      this.#grid.replaceChildren(...entries.map(({ name }) => /** @type {Drawn} */ (this.#cards.get(name)).card));
      this.#fetch(fresh.map(({ name }) => name));
    }
    this.#sift();
  }

  /** @param {RecordingEntry} entry @returns {Drawn} */
  #empty({ name, running }) {
    const card = button('', `Open ${name}`, () => this.choose(name));
    card.dataset.recording = name;
    const picture = element('div', { class: 'recording-picture' });
    const teams = element('strong', {}, '…');
    const facts = element('span', { class: 'faint' });
    card.append(picture, teams, facts, element('span', { class: 'faint' }, running ? `${name} · now` : name));
    return { card, picture, teams, facts, words: name.toLowerCase() };
  }

  /** One after the other, so that the newest come first and the server is not flooded. @param {string[]} names */
  async #fetch(names) {
    for (const name of names) {
      const drawn = this.#cards.get(name);
      const content = drawn && (await loadCard(this.token, name).catch(() => undefined));
      if (drawn && content) {
        fill(drawn, content);
      } else if (drawn) {
        setText(drawn.teams, 'cannot be read');
      }
      this.#sift();
    }
  }

  #sift() {
    const wanted = this.#search.value.trim().toLowerCase();
    let found = 0;
    for (const { card, words } of this.#cards.values()) {
      card.hidden = !words.includes(wanted);
      found += card.hidden ? 0 : 1;
    }
    this.#nothing.hidden = found > 0;
    setText(this.#nothing, this.#cards.size === 0 ? 'Nothing is recorded yet.' : `Nothing is found for “${wanted}”.`);
  }
}

/** @param {Drawn} drawn @param {RecordingCard} content */
function fill(drawn, content) {
  const { left, right, score, seconds } = content;
  const title = left && right ? `${left} ${score.join(' : ')} ${right}` : left || right || 'no robot';
  const events = Object.entries(content.events).map(([kind, count]) => `${count} ${EVENTS[kind][count === 1 ? 0 : 1]}`);
  const robots = content.robots === 1 ? '1 robot' : `${content.robots} robots`;
  setText(drawn.teams, title);
  setText(drawn.facts, [clock(seconds), robots, ...events].join(' · '));
  drawn.picture.replaceChildren(smallPitch(content));
  drawn.words = `${drawn.words} ${title} ${events.join(' ')}`.toLowerCase();
}

/** @param {RecordingCard} content */
function smallPitch({ pitch: [length, width], ball, places }) {
  const [x, y] = [-length / 2 - 1, -width / 2 - 1];
  const line = { class: 'line' };
  return shape(
    'svg',
    { viewBox: `${x} ${y} ${length + 2} ${width + 2}`, 'aria-hidden': 'true' },
    shape('rect', { x: -length / 2, y: -width / 2, width: length, height: width, ...line }),
    shape('line', { y1: -width / 2, y2: width / 2, ...line }),
    shape('circle', { r: length / 12, ...line }),
    ...places.map(([px, py, side]) => shape('circle', { cx: px, cy: -py, r: length / 40, class: SIDES[side] })),
    shape('circle', { cx: ball[0], cy: -ball[1], r: length / 80, class: 'ball' }),
  );
}
