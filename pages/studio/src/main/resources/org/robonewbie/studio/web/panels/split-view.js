/**
 * Split view: panels side by side, with edges that can be moved with the mouse or the arrow keys; each room's layout is stored in the
 * browser.
 */
import {
  EDGE_PIXELS,
  defaultLayout,
  placed,
  restoredLayout,
  toggled,
  widthOf,
  withEdgeMoved,
} from '../state/layout.js';
import { element } from './elements.js';
import { keep, recall } from './memory.js';

/**
 * @typedef {import('../state/layout.js').PanelName} PanelName
 * @typedef {import('../state/layout.js').PanelRoom} PanelRoom
 * @typedef {import('../state/layout.js').Edge} Edge
 */

const KEY = 'robonewbie-panels';
const KEY_STEP = 0.03;
/** @type {Record<string, [number, number]>} steps to the right and down */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export class SplitView {
  /** Stored layouts by room and width. @type {Record<string, unknown>} */
  #kept = recall(KEY, {});
  /** The room whose layout is shown. @type {PanelRoom} */
  room = 'field';
  /** @type {HTMLElement[]} */
  #edges = [];

  /**
   * @param {HTMLElement} place container of all panels
   * @param {() => Map<PanelName, HTMLElement>} panels existing panels of the room, always including the 3D view
   * @param {() => void} changed called after a change of the layout or the size; draws this view
   */
  constructor(place, panels, changed) {
    this.place = place;
    this.panels = panels;
    this.changed = changed;
    new ResizeObserver(() => requestAnimationFrame(changed)).observe(place);
  }

  get layout() {
    return restoredLayout(this.#kept[this.#key], this.room, this.#width);
  }

  get #width() {
    return widthOf(this.place.clientWidth || innerWidth);
  }

  /** Storage key of the layout. */
  get #key() {
    return `${this.room}-${this.#width}`;
  }

  /** @param {PanelName} name */
  toggle(name) {
    this.#set(toggled(this.layout, name));
  }

  /** Restores the default layout. */
  reset() {
    this.#set(defaultLayout(this.room, this.#width));
  }

  /** @param {import('../state/layout.js').Layout} layout */
  #set(layout) {
    this.#kept = { ...this.#kept, [this.#key]: layout };
    keep(KEY, this.#kept);
    this.changed();
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.place;
    if (width === 0) {
      return;
    }
    const { boxes, edges } = placed(this.layout, width, height);
    this.panels().forEach((panel, name) => {
      const box = boxes.get(name);
      panel.hidden = !box;
      if (box) {
        moveTo(panel, box);
      }
    });
    this.#drawEdges(edges);
  }

  /** @param {Edge[]} edges */
  #drawEdges(edges) {
    while (this.#edges.length > edges.length) {
      this.#edges.pop()?.remove();
    }
    edges.forEach((edge, i) => {
      this.#edges[i] ??= this.#newEdge(i);
      const made = this.#edges[i];
      const isColumn = edge.panel === undefined;
      Object.assign(made.dataset, { column: edge.column, panel: edge.panel ?? '' });
      made.setAttribute('aria-orientation', isColumn ? 'vertical' : 'horizontal');
      made.setAttribute('aria-valuenow', String(edge.percent));
      made.setAttribute('aria-label', edge.label);
      moveTo(made, edge.box);
    });
  }

  /** @param {number} index */
  #newEdge(index) {
    const hint = 'Drag, or press the arrow keys; double-click to restore the default layout';
    const limits = { 'aria-valuemin': '0', 'aria-valuemax': '100', 'aria-valuenow': '50' };
    const made = element('div', { class: 'edge', role: 'separator', tabindex: '0', title: hint, ...limits });
    made.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      made.focus();
      made.setPointerCapture(event.pointerId);
    });
    made.addEventListener('pointermove', (event) => {
      if (made.hasPointerCapture(event.pointerId)) {
        this.#moveTo(index, event.clientX, event.clientY);
      }
    });
    made.addEventListener('keydown', (event) => {
      const [right, down] = ARROWS[event.key] ?? [0, 0];
      const by = this.#edgeOf(made).panel === undefined ? right : down;
      if (by !== 0) {
        event.preventDefault();
        event.stopPropagation();
        this.#set(withEdgeMoved(this.layout, this.#edgeOf(made), by * KEY_STEP));
      }
    });
    made.addEventListener('dblclick', () => this.reset());
    this.place.append(made);
    return made;
  }

  /** @param {HTMLElement} made */
  #edgeOf({ dataset }) {
    return { column: Number(dataset.column), panel: dataset.panel === '' ? undefined : Number(dataset.panel) };
  }

  /** @param {number} index @param {number} x pointer position @param {number} y */
  #moveTo(index, x, y) {
    const made = this.#edges[index];
    const [box, all] = [made.getBoundingClientRect(), this.place.getBoundingClientRect()];
    const edge = this.#edgeOf(made);
    const by =
      edge.panel === undefined
        ? (x - box.left - EDGE_PIXELS / 2) / all.width
        : (y - box.top - EDGE_PIXELS / 2) / all.height;
    this.#set(withEdgeMoved(this.layout, edge, by));
  }
}

/** @param {HTMLElement} what @param {import('../state/layout.js').Box} to */
function moveTo(what, { left, top, width, height }) {
  Object.assign(what.style, { left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` });
}
