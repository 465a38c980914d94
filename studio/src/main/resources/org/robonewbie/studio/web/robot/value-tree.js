/** All values that can be plotted, as a tree of groups. */
import { element, setText } from '../panels/elements.js';

/** @typedef {import('../state/robot/traces.js').Traces} Traces */

/**
 * @param {(name: string) => void} toggle
 * @returns {{place: HTMLElement, draw: (traces: Traces, chosen: readonly string[]) => void}}
 */
export function valueTree(toggle) {
  const place = element('div', { class: 'value-tree' });
  /** @type {Map<string, HTMLInputElement>} */
  const boxes = new Map();
  /** @type {Map<string, HTMLElement>} */
  const groups = new Map();
  /** @param {string} name */
  const add = (name) => {
    const [group, ...rest] = name.split('/');
    const box = element('input', { type: 'checkbox', 'data-value': name });
    box.addEventListener('change', () => toggle(name));
    boxes.set(name, box);
    const folder = groups.get(group) ?? element('details', {}, element('summary', {}, group));
    groups.set(group, folder);
    folder.append(element('label', { class: 'check' }, box, rest.join('/')));
    place.append(folder);
  };
  return {
    place,
    draw(traces, chosen) {
      for (const name of traces.names.keys()) {
        if (!boxes.has(name)) {
          add(name);
        }
      }
      for (const [name, box] of boxes) {
        box.checked = chosen.includes(name);
        box.disabled = !traces.names.has(name) && !chosen.includes(name);
      }
      for (const [group, folder] of groups) {
        const count = chosen.filter((name) => name.startsWith(`${group}/`)).length;
        setText(/** @type {Element} */ (folder.firstElementChild), count > 0 ? `${group} (${count})` : group);
      }
    },
  };
}
