/** Bookmarks of the open recording: moments with notes, to which the user can jump or link. */
import { button, element, setText } from '../panels/elements.js';
import { MOMENTS_PER_SECOND } from '../state/replay/replay-state.js';
import { addBookmark, attempt, deleteBookmark } from './recording-api.js';

/**
 * @typedef {import('./recording-api.js').Bookmark} Bookmark
 *
 * @typedef {object} Actions
 * @property {() => number} now the index of the displayed moment
 * @property {(index: number) => void} goTo
 * @property {() => Promise<void>} changed called when the list of recordings must be reloaded
 * @property {(text: string) => void} note
 */

/** @param {string} name name of a recording @param {number} seconds @returns {string} address fragment of this moment */
export const momentLink = (name, seconds) => `#replay/${encodeURIComponent(name)}@${seconds}`;

export class BookmarkList {
  #list = element('ol', { class: 'bookmark-list' });
  #summary = element('summary', { id: 'bookmarks-open' }, 'Bookmarks');
  #field = element('input', {
    id: 'bookmark-note',
    placeholder: 'Note for this moment',
    'aria-label': 'Note for this moment',
    maxlength: '300',
  });
  #undo = button('Undo', 'Restores the last deleted bookmark', () => this.#bringBack(), { hidden: '' });
  #drawn = '';
  /** Deleted bookmarks, the most recent last. @type {Bookmark[]} */
  #deleted = [];

  /** @param {Actions} actions */
  constructor(actions) {
    this.actions = actions;
    this.recording = '';
    const form = element('form', { class: 'bookmark-form' }, this.#field, this.#undo);
    form.prepend(element('button', { id: 'bookmark-add', title: 'Bookmark this moment with the note' }, 'Add'));
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#add();
    });
    this.element = element(
      'details',
      { class: 'bookmarks' },
      this.#summary,
      element('div', { class: 'panel bookmark-sheet' }, form, this.#list),
    );
  }

  /** Opens the input field for the note of a new bookmark. */
  ask() {
    this.element.open = true;
    this.#field.focus();
  }

  /** @param {string} recording @param {readonly Bookmark[]} bookmarks */
  draw(recording, bookmarks) {
    const key = JSON.stringify([recording, bookmarks]);
    if (key === this.#drawn) {
      return;
    }
    this.#drawn = key;
    if (recording !== this.recording) {
      this.recording = recording;
      this.#deleted = [];
      this.#undo.hidden = true;
    }
    setText(this.#summary, bookmarks.length > 0 ? `Bookmarks (${bookmarks.length})` : 'Bookmarks');
    this.#list.replaceChildren(...bookmarks.map((each) => this.#line(each)));
  }

  /** @param {Bookmark} bookmark */
  #line({ seconds, note }) {
    const name = `${seconds.toFixed(2)} s`;
    const quiet = (/** @type {string} */ text, /** @type {string} */ hint, /** @type {() => void} */ act) =>
      button(text, hint, act, { class: 'quiet', 'aria-label': hint });
    return element(
      'li',
      {},
      button(
        `${name} ${note}`,
        'Go to this moment',
        () => this.actions.goTo(Math.round(seconds * MOMENTS_PER_SECOND)),
        {
          class: 'bookmark-go',
        },
      ),
      quiet('Link', `Copy a link to ${name}`, () => this.#copy(seconds)),
      quiet('Delete', `Delete the bookmark at ${name}`, () => this.#remove({ seconds, note })),
    );
  }

  #add() {
    const seconds = Math.round(this.actions.now()) / MOMENTS_PER_SECOND;
    const note = this.#field.value.trim();
    this.#field.value = '';
    attempt(() => addBookmark(this.recording, { seconds, note }), this.actions);
  }

  /** @param {Bookmark} bookmark */
  #remove(bookmark) {
    this.#deleted.push(bookmark);
    this.#undo.hidden = false;
    attempt(() => deleteBookmark(this.recording, bookmark.seconds), this.actions);
  }

  #bringBack() {
    const bookmark = this.#deleted.pop();
    this.#undo.hidden = this.#deleted.length === 0;
    if (bookmark) {
      attempt(() => addBookmark(this.recording, bookmark), this.actions);
    }
  }

  /** @param {number} seconds */
  async #copy(seconds) {
    const link = momentLink(this.recording, seconds);
    history.replaceState(undefined, '', link);
    try {
      await navigator.clipboard.writeText(location.href);
      this.actions.note('The link to this moment was copied.');
    } catch {
      this.actions.note('The link to this moment is in the address bar; copy it from there.');
    }
  }
}
