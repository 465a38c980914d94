/** Scenes: the present state is kept under a name, and one can go back to it as often as one likes. */
import { button, byId, element } from './elements.js';

/** @param {string} token @param {string} path @param {RequestInit} [options] */
async function ask(token, path, options = {}) {
  const answer = await fetch(`api/${path}`, { ...options, headers: { 'Studio-Token': token, ...options.headers } });
  if (!answer.ok) {
    throw new Error(await answer.text());
  }
  return answer.json();
}

/**
 * Lets the simulation go on from a moment of a recording.
 *
 * @param {string} token
 * @param {string} recording
 * @param {number} moment
 */
export function startFrom(token, recording, moment) {
  return ask(token, `start/${encodeURIComponent(recording)}?moment=${moment}`, { method: 'POST' });
}

/**
 * @param {string} token
 * @param {(text: string) => void} note
 * @param {() => void} goLive shows what happens now
 * @returns {(state: import('../state/studio-state.js').StudioState) => void} draws the scenes
 */
export function scenePanel(token, note, goLive) {
  const name = element('input', { id: 'scene-name', placeholder: 'Name', 'aria-label': 'Name of the scene', maxlength: '60' });
  const list = element('select', { id: 'scene-list', 'aria-label': 'Saved scenes' });
  /** What would undo each change, the newest last. @type {Array<() => Promise<void>>} */
  const undoing = [];
  const refresh = async (/** @type {string} */ chosen = list.value) => {
    const { scenes } = await ask(token, 'scenes');
    list.replaceChildren(...scenes.map((/** @type {string} */ each) => element('option', { value: each }, each)));
    list.value = scenes.includes(chosen) ? chosen : (scenes[0] ?? '');
    for (const control of [list, back, rename, remove]) {
      control.disabled = scenes.length === 0;
    }
    undo.disabled = undoing.length === 0;
  };
  /** Deeds are done one after the other, however fast one clicks. @type {Promise<void>} */
  let last = Promise.resolve();
  /** @param {string} id @param {string} title @param {string} hint @param {() => Promise<void>} deed */
  const control = (id, title, hint, deed) => {
    const made = button(title, hint, () => {
      last = last.then(deed).catch((error) => note(error.message));
    });
    made.id = id;
    return made;
  };
  const put = (/** @type {string} */ scene, /** @type {string} */ how = '') => ask(token, `scenes/${encodeURIComponent(scene)}${how}`, { method: 'PUT' });
  const renamed = async (/** @type {string} */ from, /** @type {string} */ to) => {
    await put(to, `?was=${encodeURIComponent(from)}`);
    await refresh(to);
  };
  /** Empties the field, unless another name was written meanwhile. @param {string} used */
  const forgetName = (used) => {
    name.value = name.value.trim() === used ? '' : name.value;
  };
  const save = control('scene-save', 'Save', 'Keeps ball, robots, score and time as they are now', async () => {
    const chosen = name.value.trim() || `Scene ${list.options.length + 1}`;
    await put(chosen);
    await refresh(chosen);
    forgetName(chosen);
    note(`Scene "${chosen}" is saved.`);
  });
  const back = control('scene-restore', 'Go back to it', 'Puts everything where it was, with the clock stopped', async () => {
    await ask(token, `scenes/${encodeURIComponent(list.value)}`, { method: 'POST' });
    goLive();
  });
  const rename = control('scene-rename', 'Rename', 'Gives the chosen scene the name that is written above', async () => {
    const [from, to] = [list.value, name.value.trim()];
    if (to === '') {
      name.focus();
      throw new Error('Write the new name first, in the field above.');
    }
    undoing.push(() => renamed(to, from));
    await renamed(from, to).catch((error) => (undoing.pop(), Promise.reject(error)));
    forgetName(to);
  });
  const remove = control('scene-remove', 'Delete', 'Takes the chosen scene away; Undo brings it back', async () => {
    const scene = list.value;
    await ask(token, `scenes/${encodeURIComponent(scene)}`, { method: 'DELETE' });
    undoing.push(() => put(scene, '?removed=yes').then(() => refresh(scene)));
    await refresh();
    note(`Scene "${scene}" is deleted. Undo brings it back.`);
  });
  const undo = control('scene-undo', 'Undo', 'Takes the last rename or deletion back', async () => {
    await undoing.at(-1)?.();
    undoing.pop();
    await refresh();
  });
  const panel = byId('scenes');
  const line = (/** @type {HTMLElement[]} */ ...parts) => element('div', { class: 'scene-line' }, ...parts);
  panel.append(element('h2', {}, 'Scenes'), line(name, save), line(list, back), line(rename, remove, undo));
  let asked = false;
  return ({ scene, frame }) => {
    panel.hidden = !scene || !frame || scene.clock === false;
    if (!panel.hidden && !asked) {
      asked = true;
      refresh().catch(() => {});
    }
  };
}
