/** Panels around the 3D view, the menu that shows or hides them, and the collapsible tools over the 3D view. */
import { PANEL_TITLES, panelsOf, shows } from '../state/layout.js';
import { button, byId, check } from './elements.js';
import { keep, recall } from './memory.js';
import { SplitView } from './split-view.js';

/**
 * @typedef {import('./rooms.js').RoomName} RoomName
 * @typedef {import('../state/layout.js').PanelName} PanelName
 */

const KEY = 'robonewbie-tools';
const FOCUSABLE = 'button:enabled, input:enabled, select:enabled, a[href], summary, [tabindex]:not([tabindex="-1"])';
const MIN_HIDDEN_PIXELS = 12;

/** Panels that cannot be hidden. @type {PanelName[]} */
const FIXED = ['picture', 'code'];

export class Workspace {
  /** @type {RoomName} */
  #room = 'field';
  /** Whether a robot's panels are shown. */
  showsRobot = false;
  /** The robot shown by both the 3D view and the panels. */
  #robot = 0;
  /** Whether the tools are expanded, by room. @type {Record<string, boolean>} */
  #tools = recall(KEY, {});

  /** @param {(room: 'robot' | 'program') => Promise<void> | void} openPanels creates the panels on first use */
  constructor(openPanels) {
    this.openPanels = openPanels;
    this.split = new SplitView(byId('workspace'), panelsHere, () => this.#draw());
    this.tools = byId('side-fold');
    this.tools.addEventListener('click', () => this.#foldTools());
    byId('panels').addEventListener('beforetoggle', () => this.#listPanels());
  }

  /** @param {RoomName} room */
  enter(room) {
    this.#room = room;
    byId('panels-button').hidden = room === 'motion';
    if (room !== 'motion') {
      this.split.room = room;
    }
    this.#draw();
  }

  /** The panels of this room that can be hidden. */
  get #optional() {
    return panelsOf(this.split.layout).filter((name) => !FIXED.includes(name));
  }

  /**
   * Makes the 3D view and the panels show the same robot; the most recent choice takes precedence.
   *
   * @param {{chosen: number}} picture
   * @param {{chosen: number}} panels
   */
  agreeOnRobot(picture, panels) {
    if (picture.chosen !== this.#robot) {
      panels.chosen = picture.chosen;
    } else {
      picture.chosen = panels.chosen;
    }
    this.#robot = picture.chosen;
  }

  /** Marks panels whose content continues below their lower edge, and makes them focusable. Call periodically. */
  markMore() {
    for (const panel of document.querySelectorAll('#side, .panel-inside, .curves, .log')) {
      const hidden = panel.scrollHeight - panel.clientHeight - panel.scrollTop;
      panel.toggleAttribute('data-more', hidden > MIN_HIDDEN_PIXELS);
    }
    for (const panel of document.querySelectorAll('.panel-inside')) {
      const inside = [...panel.querySelectorAll(FOCUSABLE)];
      if (panel.scrollHeight > panel.clientHeight && !inside.some((one) => one.checkVisibility())) {
        panel.setAttribute('tabindex', '0');
      } else {
        panel.removeAttribute('tabindex');
      }
    }
  }

  /** @param {'robot' | 'program'} room */
  async #open(room) {
    await this.openPanels(room);
    this.split.draw();
  }

  /** Fills the panel menu. */
  #listPanels() {
    const reset = button('Reset', 'Restore the default panels of this room', () => {
      this.split.reset();
      this.#listPanels();
    });
    const checks = this.#optional.map((name) => {
      const { box, label } = check(`panel-${name}`, PANEL_TITLES[name], '', () => this.split.toggle(name));
      box.checked = shows(this.split.layout, name);
      return label;
    });
    byId('panels').replaceChildren(...checks, reset);
  }

  #foldTools() {
    this.#tools[this.#room] = !this.#tools[this.#room];
    keep(KEY, this.#tools);
    this.#draw();
  }

  #draw() {
    const isUnfolded = this.#tools[this.#room] === true;
    byId('side').dataset.folded = String(!isUnfolded);
    this.tools.setAttribute('aria-expanded', String(isUnfolded));
    this.tools.title = isUnfolded ? 'Hide the tools' : 'Tools for camera, game, scenes and puppets';
    const isProgram = this.#room === 'program';
    this.showsRobot =
      !isProgram && this.#room !== 'motion' && this.#optional.some((name) => shows(this.split.layout, name));
    byId('robot-room').hidden = !this.showsRobot;
    byId('program-room').hidden = !isProgram;
    this.split.draw();
    if (this.showsRobot || isProgram) {
      this.#open(isProgram ? 'program' : 'robot');
    }
  }
}

/** @returns {Map<PanelName, HTMLElement>} */
function panelsHere() {
  const panels = [
    .../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('#workspace > :not([hidden]) > .side-panel')),
  ];
  return new Map([
    ['picture', byId('field-room')],
    ...panels.map((panel) => /** @type {[PanelName, HTMLElement]} */ ([panel.dataset.panel, panel])),
  ]);
}
