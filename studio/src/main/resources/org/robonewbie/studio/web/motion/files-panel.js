/** The motions of the folder, those of the library, and postures to begin with. */
import { button, element } from '../panels/elements.js';
import { isUnsaved, postureNow, posed } from '../state/motion/editor-state.js';
import { usualPostures } from '../state/motion/poses.js';
import { namelessDrafts } from './drafts.js';
import { takeTyped } from './number-field.js';
import { ask } from './questions.js';

/** @typedef {import('./editor.js').Editor} Editor */

/**
 * @param {HTMLElement} place
 * @param {Editor} editor
 * @param {(work: Promise<unknown>) => void} run
 * @param {import('./orders.js').Order[]} orders
 * @returns {() => void} draws the lists
 */
export function filesPanel(place, editor, run, orders) {
  const panel = new FilesPanel(editor, run);
  const order = orders.find(({ id }) => id === 'import');
  const importing = button(order?.name ?? '', order?.hint ?? '', () => order?.act(), { id: 'import' });
  place.append(...panel.parts(importing));
  return () => panel.draw();
}

class FilesPanel {
  #shown = '';
  #own = element('ul', { class: 'list', id: 'own-motions' });
  #library = element('ul', { class: 'list', id: 'library-motions' });
  #postures = element('div', { class: 'postures' });
  #folder = element('p', { class: 'faint folder' });

  /** @param {Editor} editor @param {(work: Promise<unknown>) => void} run */
  constructor(editor, run) {
    this.editor = editor;
    this.run = run;
  }

  /** @param {HTMLElement} importing */
  parts(importing) {
    const { editor, run } = this;
    const begin = () => (takeTyped(), run(editor.create()));
    const keep = () => run(keepPosture(editor));
    const create = button('+ New', 'A new motion that begins with standing', begin, { id: 'new-motion' });
    return [
      element('div', { class: 'list-head' }, element('h2', {}, 'Your motions'), create),
      this.#own,
      this.#folder,
      importing,
      element('h2', {}, 'Library'),
      this.#library,
      element('h2', {}, 'Postures'),
      this.#postures,
      button('Keep this posture…', 'Remember the posture under a name', keep, { id: 'keep-posture' }),
    ];
  }

  draw() {
    const { state, list, postures } = this.editor;
    const names = postures.map(({ name }) => name);
    const now = JSON.stringify([list, state.name, state.draft, state.version, isUnsaved(state), names]);
    if (now !== this.#shown) {
      this.#shown = now;
      this.#drawMotions();
      this.#drawPostures();
    }
  }

  #drawMotions() {
    const { editor, run } = this;
    const { state, list } = editor;
    const openOwn = state.version === '' ? undefined : state.name;
    const openShipped = state.version === '' ? state.name : undefined;
    this.#own.replaceChildren(
      ...list.own.map(({ name }) =>
        entry(name, name === openOwn, () => run(editor.open('motions', name)), hasDraft(editor, name)),
      ),
    );
    this.#own.append(
      ...namelessDrafts(list).map((draft) =>
        entry(draft, state.name === '' && draft === state.draft, () => run(editor.openDraft(draft)), true),
      ),
    );
    this.#own.hidden = this.#own.children.length === 0;
    this.#folder.textContent = list.own.length === 0 ? `None yet. They are kept in ${list.folder}` : '';
    this.#folder.hidden = list.own.length > 0;
    this.#library.replaceChildren(
      ...list.library.map((name) => entry(name, name === openShipped, () => run(editor.open('library', name)), false)),
    );
  }

  #drawPostures() {
    const { editor } = this;
    const all = [...usualPostures(editor.state.body), ...editor.postures];
    const give = (/** @type {string} */ name, /** @type {readonly number[]} */ degrees) => () =>
      editor.apply((each) => posed({ ...each, symmetric: false }, degrees, `Posture ${name}`));
    this.#postures.replaceChildren(
      ...all.map(({ name, degrees }) => button(name, `Give the keyframe the posture “${name}”`, give(name, degrees))),
    );
  }
}

/** @param {Editor} editor @param {string} name */
function hasDraft(editor, name) {
  return name === editor.state.name ? isUnsaved(editor.state) : editor.list.drafts.some((draft) => draft.name === name);
}

/**
 * @param {string} name
 * @param {boolean} isOpen
 * @param {() => void} open
 * @param {boolean} changed
 */
function entry(name, isOpen, open, changed) {
  const act = () => (takeTyped(), open());
  const made = button(changed ? `${name} •` : name, changed ? 'Has unsaved changes' : `Open “${name}”`, act);
  made.dataset.motion = name;
  if (isOpen) {
    made.setAttribute('aria-current', 'true');
  }
  return element('li', {}, made);
}

/** @param {Editor} editor */
async function keepPosture(editor) {
  const degrees = [...postureNow(editor.state)];
  const name = await ask({
    title: 'Keep this posture',
    label: 'Name',
    value: 'My posture',
    action: 'Keep',
    pattern: /^[^\r\n]{1,40}$/,
    hint: 'It can be given to any keyframe of any motion.',
  });
  if (name !== undefined) {
    await editor.keepPosture(name, degrees);
  }
}
