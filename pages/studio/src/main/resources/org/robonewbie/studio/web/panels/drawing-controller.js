/** Shows the robots' drawings, with a tree of layers that can be switched on and off. */
import { CYCLE_SECONDS } from '../state/cycle.js';
import { ALL_DRAWINGS, DrawingLayers, KINDS, layerOf } from '../state/drawing-layers.js';
import { standOf } from '../state/drawing-shapes.js';
import { figureOf } from '../state/figure.js';
import { robotKey } from '../state/robot/telemetry.js';
import { byId, element } from './elements.js';
import { keep, recall } from './memory.js';

/**
 * @typedef {import('../state/robot/drawing-memory.js').DrawingMemory} DrawingMemory
 * @typedef {{scene?: import('../live/state-frame.js').Scene, frame?: import('../live/state-frame.js').Frame}} Moment
 */

const KEY = 'robonewbie-drawings-off';

export class DrawingController {
  /**
   * @param {import('../field/field-view.js').FieldView} view
   * @param {() => void} changed requests a redraw
   */
  constructor(view, changed) {
    this.view = view;
    this.changed = changed;
    this.layers = new DrawingLayers(recall(KEY, /** @type {string[]} */ ([])));
    this.listed = '';
    this.tree = element('div', { class: 'layer-tree' });
    this.panel = byId('drawings');
    this.panel.append(
      this.#check(ALL_DRAWINGS, 'Drawings', 'What robots draw on the pitch (D)'),
      element('details', {}, element('summary', {}, 'Layers'), this.tree),
    );
    this.panel.hidden = true;
  }

  /** The key action. @returns {import('./keys.js').Action} */
  get action() {
    const act = () => this.#set(ALL_DRAWINGS, !this.layers.isOn(ALL_DRAWINGS));
    return { keys: ['d', 'D'], shown: 'D', text: 'show or hide the robots’ drawings', act };
  }

  /** @param {Moment} moment displayed moment @param {DrawingMemory} memory */
  show({ scene, frame }, memory) {
    const seconds = (frame?.cycle ?? 0) * CYCLE_SECONDS;
    const placed = [...memory.kinds.keys()].flatMap((robot) => {
      const index = scene?.robots.findIndex(({ team, number }) => robotKey(team, number) === robot) ?? -1;
      const poses = this.view.robots.poses[index];
      if (!scene || !poses) {
        return [];
      }
      const { head } = figureOf(scene.models[scene.robots[index].type]);
      const drawings = memory.at(robot, seconds).filter(({ shape }) => this.layers.shows(robot, shape));
      return drawings.map((drawing) => ({ stand: standOf(poses, head), drawing }));
    });
    this.view.drawings.show(placed);
    this.#list(memory.kinds);
  }

  /** @param {ReadonlyMap<string, ReadonlySet<string>>} kinds kinds of drawings made by each robot */
  #list(kinds) {
    const listing = [...kinds].map(([robot, made]) => `${robot}\n${[...made].join()}`).join('\n');
    if (listing !== this.listed) {
      this.listed = listing;
      this.panel.hidden = kinds.size === 0;
      this.tree.replaceChildren(...[...kinds.keys()].sort().flatMap((robot) => this.#robot(robot, kinds.get(robot))));
    }
  }

  /** @param {string} robot its key @param {ReadonlySet<string>} [made] its kinds of drawings */
  #robot(robot, made) {
    const name = robot.replace('\t', ' ');
    const kinds = Object.entries(KINDS)
      .filter(([kind]) => made?.has(kind))
      .map(([kind, text]) => this.#check(layerOf(robot, kind), text, `${text} of ${name}`));
    return [this.#check(robot, name, `All drawings of ${name}`), element('div', { class: 'layer-kinds' }, ...kinds)];
  }

  /** @param {string} layer @param {string} text @param {string} hint */
  #check(layer, text, hint) {
    const box = element('input', { type: 'checkbox', 'data-layer': layer });
    box.checked = this.layers.isOn(layer);
    box.addEventListener('change', () => this.#set(layer, box.checked));
    return element('label', { class: 'check', title: hint }, box, text);
  }

  /** @param {string} layer @param {boolean} on */
  #set(layer, on) {
    this.layers.set(layer, on);
    keep(KEY, [...this.layers.off]);
    for (const box of this.panel.querySelectorAll('input')) {
      box.checked = this.layers.isOn(box.dataset.layer ?? '');
    }
    this.changed();
  }
}
