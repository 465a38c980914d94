/** Panel that lists the motions in the user's folder, the motions in the library, and template postures. */
import { button, element } from '../panels/elements.js';
import { isUnsaved, postureNow, posed } from '../state/motion/editor-state.js';
import { templatePostures } from '../state/motion/poses.js';
import { namelessDrafts } from './drafts.js';
import { takeTyped } from './number-field.js';
import { ask } from '../panels/questions.js';

/** @typedef {import('./editor.js').Editor} Editor */

/**
 * @param {HTMLElement} place
 * @param {Editor} editor
 * @param {(work: Promise<unknown>) => void} run
 * @param {import('./orders.js').Order[]} orders
 * @returns {() => void} function that updates the lists
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
  #keepPosture = button(
    'Save this posture…',
    'Save the posture under a name',
    () => this.run(keepPosture(this.editor)),
    {
      id: 'keep-posture',
    },
  );
  #folder = element('p', { class: 'faint folder' });
  /** Files in the folder that cannot be played, with the reasons. */
  #leftOut = element('ul', { class: 'faint folder', id: 'left-out-motions' });

  /** @param {Editor} editor @param {(work: Promise<unknown>) => void} run */
  constructor(editor, run) {
    this.editor = editor;
    this.run = run;
  }

  /** @param {HTMLElement} importing */
  parts(importing) {
    const { editor, run } = this;
    const begin = () => (takeTyped(), run(editor.create()));
    const create = button(
      '+ New',
      'A new motion that starts from standing, for the same robot as the open one',
      begin,
      { id: 'new-motion' },
    );
    return [
      element('div', { class: 'list-head' }, element('h2', {}, 'Your motions'), create),
      this.#own,
      this.#folder,
      this.#leftOut,
      importing,
      element('h2', {}, 'Library'),
      this.#library,
      element('h2', {}, 'Postures'),
      this.#postures,
      this.#keepPosture,
    ];
  }

  draw() {
    const { state, list, postures } = this.editor;
    const names = postures.map(({ name }) => name);
    const now = JSON.stringify([
      list,
      state.body.robot,
      state.name,
      state.draft,
      state.version,
      isUnsaved(state),
      names,
    ]);
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
    fill(this.#own, [
      ...list.own.map(({ name }) => ({
        name,
        isOpen: name === openOwn,
        open: () => run(editor.open('motions', name)),
        changed: hasDraft(editor, name),
      })),
      ...namelessDrafts(list).map((draft) => ({
        name: draft,
        isOpen: state.name === '' && draft === state.draft,
        open: () => run(editor.openDraft(draft)),
        changed: true,
      })),
    ]);
    this.#own.hidden = this.#own.children.length === 0;
    this.#folder.textContent = `Saved in ${list.folder}`;
    this.#folder.hidden = list.own.length > 0;
    this.#leftOut.replaceChildren(...list.leftOut.map((sentence) => element('li', {}, sentence)));
    this.#leftOut.hidden = list.leftOut.length === 0;
    fill(
      this.#library,
      list.library.map((name) => ({
        name,
        isOpen: name === openShipped,
        open: () => run(editor.open('library', name)),
        changed: false,
      })),
    );
  }

  #drawPostures() {
    const { editor } = this;
    const { body } = editor.state;
    const all = [...templatePostures(body), ...(body.isNao ? editor.postures : [])];
    this.#keepPosture.hidden = !body.isNao;
    const give = (/** @type {string} */ name, /** @type {readonly number[]} */ degrees) => () =>
      editor.apply((each) => posed({ ...each, symmetric: false }, degrees, `Posture ${name}`));
    this.#postures.replaceChildren(
      ...all.map(({ name, degrees }) => button(name, `Set the keyframe to the posture “${name}”`, give(name, degrees))),
    );
  }
}

/** @param {Editor} editor @param {string} name */
function hasDraft(editor, name) {
  return name === editor.state.name ? isUnsaved(editor.state) : editor.list.drafts.some((draft) => draft.name === name);
}

/**
 * @typedef {object} Entry entry of a list of motions
 * @property {string} name
 * @property {boolean} isOpen
 * @property {() => void} open
 * @property {boolean} changed
 */

/** Shows entries; existing elements are reused, so that they keep the focus. @param {HTMLElement} list @param {Entry[]} entries */
function fill(list, entries) {
  const known = new Map([...list.children].map((item) => [item.getAttribute('data-entry') ?? '', item]));
  const items = entries.map((entry) => {
    const key = `${entry.name} ${entry.changed}`;
    const item = known.get(key) ?? element('li', { 'data-entry': key }, entryButton(entry));
    const made = /** @type {HTMLButtonElement} */ (item.firstElementChild);
    made.onclick = () => (takeTyped(), entry.open());
    if (entry.isOpen) {
      made.setAttribute('aria-current', 'true');
    } else {
      made.removeAttribute('aria-current');
    }
    return item;
  });
  [...list.children].filter((item) => !items.includes(item)).forEach((item) => item.remove());
  items.forEach((item, i) => {
    if (item !== list.children[i]) {
      list.insertBefore(item, list.children[i] ?? null); // moving the others would make them lose the focus
    }
  });
}

/** @param {Entry} entry */
function entryButton({ name, changed }) {
  const made = button(changed ? `${name} •` : name, changed ? 'Has unsaved changes' : `Open “${name}”`, () => {});
  made.dataset.motion = name;
  return made;
}

/** @param {Editor} editor */
async function keepPosture(editor) {
  const degrees = [...postureNow(editor.state)];
  const name = await ask({
    title: 'Save this posture',
    label: 'Name',
    value: 'My posture',
    action: 'Save',
    problem: (answer) => (/^[^\r\n]{1,40}$/.test(answer) ? '' : 'Use 1 to 40 characters.'),
    hint: 'It can be used for any keyframe of any motion.',
  });
  if (name !== undefined) {
    await editor.keepPosture(name, degrees);
  }
}
