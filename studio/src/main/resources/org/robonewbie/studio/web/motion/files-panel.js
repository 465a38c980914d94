/** The motions of the folder, those of the library, and postures to begin with. */
import { button, element } from '../panels/elements.js';
import { isUnsaved, postureNow, posed } from '../state/motion/editor-state.js';
import { usualPostures } from '../state/motion/poses.js';
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
  const own = element('ul', { class: 'list', id: 'own-motions' });
  const library = element('ul', { class: 'list', id: 'library-motions' });
  const postures = element('div', { class: 'postures' });
  const folder = element('p', { class: 'faint folder' });
  const order = orders.find(({ id }) => id === 'import');
  const importing = button(order?.name ?? '', order?.hint ?? '', () => order?.act());
  importing.id = 'import';
  const keep = button('Keep this posture…', 'Remember the posture under a name', () => run(keepPosture(editor)));
  keep.id = 'keep-posture';
  const create = button('+ New', 'A new motion that begins with standing', () => run(editor.create()));
  create.id = 'new-motion';
  place.append(
    element('div', { class: 'list-head' }, element('h2', {}, 'Your motions'), create),
    own,
    folder,
    importing,
    element('h2', {}, 'Library'),
    library,
    element('h2', {}, 'Postures'),
    postures,
    keep,
  );
  let shown = '';
  return () => {
    const { state, list } = editor;
    const now = JSON.stringify([list, state.name, state.version, isUnsaved(state), editor.postures.map(({ name }) => name)]);
    if (now === shown) {
      return;
    }
    shown = now;
    const isOwn = state.version !== '';
    own.replaceChildren(...list.own.map(({ name }) => entry(name, isOwn && name === state.name, () => run(editor.open('motions', name)), hasDraft(editor, name))));
    own.hidden = list.own.length === 0;
    folder.textContent = list.own.length === 0 ? `None yet. They are kept in ${list.folder}` : '';
    folder.hidden = list.own.length > 0;
    library.replaceChildren(...list.library.map((name) => entry(name, !isOwn && name === state.name, () => run(editor.open('library', name)), false)));
    const all = [...usualPostures(state.body), ...editor.postures];
    postures.replaceChildren(
      ...all.map(({ name, degrees }) => button(name, `Give the keyframe the posture “${name}”`, () => editor.apply((each) => posed({ ...each, symmetric: false }, degrees, `Posture ${name}`)))),
    );
  };
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
  const made = button(changed ? `${name} •` : name, changed ? 'Has unsaved changes' : `Open “${name}”`, open);
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
