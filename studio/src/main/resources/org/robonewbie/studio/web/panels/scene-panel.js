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
 * @returns {(state: import('../state/studio-state.js').StudioState) => void} draws the scenes
 */
export function scenePanel(token, note) {
  const name = element('input', { id: 'scene-name', placeholder: 'Name of the scene', 'aria-label': 'Name of the scene', maxlength: '60' });
  const list = element('select', { id: 'scene-list', 'aria-label': 'Saved scenes' });
  const act = (/** @type {() => Promise<void>} */ deed) => deed().catch((error) => note(error.message));
  const refresh = async () => {
    const { scenes } = await ask(token, 'scenes');
    list.replaceChildren(...scenes.map((/** @type {string} */ each) => element('option', { value: each }, each)));
    back.disabled = scenes.length === 0;
  };
  const save = button('Save', 'Keeps ball, robots, score and time as they are now', () =>
    act(async () => {
      const chosen = name.value.trim() || `Scene ${list.options.length + 1}`;
      await ask(token, `scenes/${encodeURIComponent(chosen)}`, { method: 'PUT' });
      await refresh();
      list.value = chosen;
      name.value = '';
      note(`Scene "${chosen}" is saved.`);
    }),
  );
  save.id = 'scene-save';
  const back = button('Go back to it', 'Puts everything where it was, with the clock stopped', () =>
    act(() => ask(token, `scenes/${encodeURIComponent(list.value)}`, { method: 'POST' })),
  );
  back.id = 'scene-restore';
  const panel = byId('scenes');
  panel.append(element('h2', {}, 'Scenes'), element('div', { class: 'scene-line' }, name, save), element('div', { class: 'scene-line' }, list, back));
  let asked = false;
  return ({ scene, frame }) => {
    panel.hidden = !scene || !frame || scene.clock === false;
    if (!panel.hidden && !asked) {
      asked = true;
      refresh().catch(() => {});
    }
  };
}
