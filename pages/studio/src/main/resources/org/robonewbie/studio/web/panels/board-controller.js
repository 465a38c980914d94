/** Controls the RoboViz drawings: keeps the sets of shapes, and lists them so that each can be switched on and off. */
import { byId, element } from './elements.js';
import { keep, recall } from './memory.js';

const KEY = 'robonewbie-board-off';
const ALL = '';

/** @typedef {import('../state/board-shapes.js').BoardShape} BoardShape */

export class BoardController {
  /** @type {Map<string, BoardShape[]>} */
  #sets = new Map();
  #off = new Set(recall(KEY, /** @type {string[]} */ ([])));

  /** @param {import('../field/board.js').Board} board @param {() => void} changed requests a redraw */
  constructor(board, changed) {
    this.board = board;
    this.changed = changed;
    this.list = element('div', { class: 'layer-tree' });
    this.panel = byId('board');
    const layers = element('details', {}, element('summary', {}, 'Sets'), this.list);
    this.panel.append(this.#check(ALL, 'Drawings for RoboViz'), layers);
  }

  /** @param {Record<string, BoardShape[]>} sets changed sets by name */
  receive(sets) {
    const isNew = Object.keys(sets).some((set) => !this.#sets.has(set));
    Object.entries(sets).forEach(([set, shapes]) => this.#sets.set(set, shapes));
    if (isNew) {
      this.panel.hidden = false;
      this.list.replaceChildren(...[...this.#sets.keys()].sort().map((set) => this.#check(set, set || 'unnamed')));
    }
    this.#show();
  }

  /** Resets everything for another simulation. */
  clear() {
    this.#sets.clear();
    this.panel.hidden = true;
    this.#show();
  }

  #show() {
    const shown = [...this.#sets].filter(([set]) => !this.#off.has(ALL) && !this.#off.has(`set ${set}`));
    this.board.show(shown.flatMap(([, shapes]) => shapes));
    this.changed();
  }

  /** @param {string} set @param {string} text */
  #check(set, text) {
    const layer = text === 'Drawings for RoboViz' ? ALL : `set ${set}`;
    const box = element('input', { type: 'checkbox' });
    box.checked = !this.#off.has(layer);
    box.addEventListener('change', () => {
      this.#off[box.checked ? 'delete' : 'add'](layer);
      keep(KEY, [...this.#off]);
      this.#show();
    });
    return element('label', { class: 'check', title: 'Drawings that teams send in the RoboViz protocol' }, box, text);
  }
}
