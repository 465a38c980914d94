/** Tree of all values that can be plotted. */
import { element, setText } from '../panels/elements.js';

/** @typedef {import('../state/robot/traces.js').Traces} Traces */

export class ValueTree {
  /** @type {Map<string, HTMLInputElement>} */
  #boxes = new Map();
  /** @type {Map<string, HTMLElement>} */
  #groups = new Map();

  /** @param {(name: string) => void} toggle */
  constructor(toggle) {
    this.toggle = toggle;
    this.place = element('div', { class: 'value-tree' });
  }

  /** @param {Traces} traces @param {readonly string[]} chosen */
  draw(traces, chosen) {
    const added = [...traces.names.keys()].filter((name) => !this.#boxes.has(name));
    added.forEach((name) => this.#add(name));
    for (const [name, box] of this.#boxes) {
      box.checked = chosen.includes(name);
      box.disabled = !traces.names.has(name) && !chosen.includes(name);
    }
    for (const [group, folder] of this.#groups) {
      const count = chosen.filter((name) => name.startsWith(`${group}/`)).length;
      setText(/** @type {Element} */ (folder.firstElementChild), count > 0 ? `${group} (${count})` : group);
    }
  }

  /** @param {string} name */
  #add(name) {
    const [group, ...rest] = name.split('/');
    const box = element('input', { type: 'checkbox', 'data-value': name });
    box.addEventListener('change', () => this.toggle(name));
    this.#boxes.set(name, box);
    const folder = this.#groups.get(group) ?? element('details', {}, element('summary', {}, group));
    this.#groups.set(group, folder);
    folder.append(element('label', { class: 'check' }, box, rest.join('/')));
    this.place.append(folder);
  }
}
