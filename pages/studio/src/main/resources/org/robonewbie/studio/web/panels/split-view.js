/** Split view: panels side by side, with edges that can be moved with mouse and arrow keys; the browser stores the layout. */
import { EDGE_PIXELS, LAYOUTS, placed, restoredLayout, toggled, widthOf, withEdgeMoved } from '../state/layout.js';
import { element } from './elements.js';
import { keep, recall } from './memory.js';

/**
 * @typedef {import('../state/layout.js').PanelName} PanelName
 * @typedef {import('../state/layout.js').Edge} Edge
 */

const KEY = 'robonewbie-layout';
const KEY_STEP = 0.03;
/** @type {Record<string, [number, number]>} steps to the right and down */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export class SplitView {
  /** Stored layouts by width. @type {Record<string, unknown>} */
  #kept = recall(KEY, {});
  /** @type {import('../state/layout.js').Layout} */
  #layout = LAYOUTS.understand.wide;
  /** @type {import('../state/layout.js').PresetName} */
  #preset = 'understand';
  /** @type {import('../state/layout.js').Width | undefined} */
  #width;
  #isOn = false;
  /** @type {HTMLElement[]} */
  #edges = [];

  /**
   * @param {HTMLElement} place container of all panels
   * @param {() => Map<PanelName, HTMLElement>} panels existing panels, always including the 3D view
   */
  constructor(place, panels) {
    this.place = place;
    this.panels = panels;
    new ResizeObserver(() => requestAnimationFrame(() => this.draw())).observe(place);
  }

  /** Whether panels are shown next to the 3D view; otherwise the 3D view fills the page. */
  get isOn() {
    return this.#isOn;
  }

  /** @param {boolean} on */
  set isOn(on) {
    this.#isOn = on;
    this.place.dataset.split = on ? 'on' : 'off';
    this.draw();
  }

  /** Sets the preset of panels next to the 3D view. @param {import('../state/layout.js').PresetName} preset */
  set preset(preset) {
    if (preset !== this.#preset) {
      this.#preset = preset;
      this.#width = undefined;
    }
  }

  /** Storage key of the layout for this width. */
  get #place() {
    const width = this.#width ?? 'wide';
    return this.#preset === 'understand' ? width : `${this.#preset}-${width}`;
  }

  /** @param {PanelName} name @returns {boolean} */
  isFolded(name) {
    return this.#layout.some(({ panels }) => panels.some((each) => each.name === name && each.folded));
  }

  /** @param {PanelName} name */
  toggle(name) {
    this.#set(toggled(this.#layout, name));
  }

  /** Restores the default layout. */
  reset() {
    this.#set(LAYOUTS[this.#preset][this.#width ?? 'wide']);
  }

  /** @param {import('../state/layout.js').Layout} layout */
  #set(layout) {
    this.#layout = layout;
    this.#kept = { ...this.#kept, [this.#place]: layout };
    keep(KEY, this.#kept);
    this.draw();
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.place;
    const panels = this.panels();
    if (!this.#isOn || width === 0) {
      panels.forEach((panel) => panel.removeAttribute('style'));
      this.#drawEdges([]);
      return;
    }
    if (this.#width !== widthOf(width)) {
      this.#width = widthOf(width);
      this.#layout = restoredLayout(this.#kept[this.#place], this.#width, this.#preset);
    }
    const { boxes, edges } = placed(this.#layout, width, height);
    panels.forEach((panel, name) => {
      const box = boxes.get(name);
      if (box) {
        moveTo(panel, box);
      }
      panel.dataset.folded = String(this.isFolded(name));
      panel.querySelector('.panel-title')?.setAttribute('aria-expanded', String(!this.isFolded(name)));
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
        this.#set(withEdgeMoved(this.#layout, this.#edgeOf(made), by * KEY_STEP));
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
    this.#set(withEdgeMoved(this.#layout, edge, by));
  }
}

/** @param {HTMLElement} what @param {import('../state/layout.js').Box} to */
function moveTo(what, { left, top, width, height }) {
  Object.assign(what.style, { left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` });
}
