/** Scenes: saves the current state under a name and restores it any number of times. */
import { answer, ask } from '../live/server.js';
import { button, byId, choice, element, setEntries } from './elements.js';

/**
 * Describes how completely a scene was restored.
 *
 * @param {{exact: boolean, agents: number}} restored
 */
export function restoredText({ exact, agents }) {
  const world = exact
    ? 'The world was restored exactly.'
    : 'The world was restored only approximately: speeds are estimated.';
  const count = agents === 1 ? 'One agent was' : `${agents} agents were`;
  return agents > 0
    ? `${world} ${count} restored with it; all others keep what they remember.`
    : `${world} Agents are not restored: they keep what they remember.`;
}

/**
 * Continues the simulation from a moment of a recording.
 *
 * @param {string} recording
 * @param {number} moment
 * @returns {Promise<{exact: boolean, agents: number}>}
 */
export async function startFrom(recording, moment) {
  return answer('POST start/NAME', { NAME: recording, moment });
}

/**
 * @param {(text: string) => void} note
 * @param {() => void} goLive returns to the present
 * @returns {(state: import('../state/studio-state.js').StudioState) => void} function that updates the scenes
 */
export function scenePanel(note, goLive) {
  const panel = new ScenePanel(note, goLive);
  return ({ scene, frame, actions }) =>
    panel.show(
      scene !== undefined && frame !== undefined && scene.clock !== false && scene.trial === undefined,
      `${actions.undo}\n${actions.redo}`,
    );
}

class ScenePanel {
  /** Serialises the actions, because the user may click again before an action is complete. @type {Promise<void>} */
  #last = Promise.resolve();
  /** Names of the undo and redo actions when the list was last read; such actions may restore or remove a scene. */
  #known = '';

  /** @param {(text: string) => void} note @param {() => void} goLive */
  constructor(note, goLive) {
    this.note = note;
    this.goLive = goLive;
    const words = { placeholder: 'Name', 'aria-label': 'Name of the scene', maxlength: '60' };
    this.name = element('input', { id: 'scene-name', ...words });
    this.list = choice({ id: 'scene-list', 'aria-label': 'Saved scenes' }, [], () => {});
    this.place = byId('scenes');
    const save = this.#control('scene-save', 'Save', 'Saves ball, robots, score and time', () => this.#save());
    this.back = this.#control('scene-restore', 'Restore', 'Restores the scene, with the clock stopped', () =>
      this.#restore(),
    );
    this.rename = this.#control(
      'scene-rename',
      'Rename',
      'Renames the selected scene to the name in the field above',
      () => this.#rename(),
    );
    this.remove = this.#control('scene-remove', 'Delete', 'Deletes the selected scene; Undo restores it', () =>
      this.#remove(),
    );
    this.place.append(
      element('h2', {}, 'Scenes'),
      element('div', { class: 'scene-line' }, this.name, save),
      element('div', { class: 'scene-line' }, this.list, this.back),
      element('div', { class: 'scene-line' }, this.rename, this.remove),
    );
  }

  /** @param {boolean} isPossible @param {string} actions actions that can be undone and redone */
  show(isPossible, actions) {
    this.place.hidden = !isPossible;
    if (isPossible && this.#known !== actions) {
      this.#known = actions;
      this.#refresh().catch(() => {});
    }
  }

  /** @param {string} id @param {string} title @param {string} hint @param {() => Promise<void>} action */
  #control(id, title, hint, action) {
    const act = () => {
      this.#last = this.#last.then(action).catch((error) => this.note(error.message));
    };
    return button(title, hint, act, { id });
  }

  async #refresh(chosen = this.list.value) {
    /** @type {{scenes: string[]}} */
    const { scenes } = await answer('GET scenes');
    setEntries(
      this.list,
      scenes.map((each) => [each, each]),
    );
    this.list.value = scenes.includes(chosen) ? chosen : (scenes[0] ?? '');
    for (const control of [this.list, this.back, this.rename, this.remove]) {
      control.disabled = scenes.length === 0;
    }
  }

  async #save() {
    const chosen = this.name.value.trim() || `Scene ${this.list.options.length + 1}`;
    await ask('PUT scenes/NAME', { NAME: chosen });
    await this.#refresh(chosen);
    this.#forgetName(chosen);
    this.note(`Scene "${chosen}" was saved.`);
  }

  async #restore() {
    const restored = await answer('POST scenes/NAME', { NAME: this.list.value });
    this.goLive();
    this.note(restoredText(restored));
  }

  async #rename() {
    const [from, to] = [this.list.value, this.name.value.trim()];
    if (to === '') {
      this.name.focus();
      throw new Error('Enter the new name in the field above first.');
    }
    await ask('PUT scenes/NAME', { NAME: to, was: from });
    await this.#refresh(to);
    this.#forgetName(to);
  }

  async #remove() {
    const scene = this.list.value;
    await ask('DELETE scenes/NAME', { NAME: scene });
    await this.#refresh();
    this.note(`Scene "${scene}" was deleted. Undo restores it.`);
  }

  /** Clears the field, unless another name has been typed in the meantime. @param {string} used */
  #forgetName(used) {
    this.name.value = this.name.value.trim() === used ? '' : this.name.value;
  }
}
