/** View presets (the 3D view alone, or with the panels of one robot next to it), and the collapsible tools over the 3D view. */
import { button, byId } from './elements.js';
import { keep, recall } from './memory.js';
import { SplitView } from './split-view.js';

/**
 * @typedef {import('./rooms.js').RoomName} RoomName
 * @typedef {import('../state/layout.js').PanelName} PanelName
 *
 * @typedef {object} Preset
 * @property {string} name
 * @property {string} hint
 * @property {RoomName} [room] room to open if the current room lacks this preset
 */

/** @type {Preset[]} */
const PRESETS = [
  { name: 'Watch', hint: 'The picture only', room: 'field' },
  { name: 'Understand', hint: 'Picture, curves, joints, log and messages side by side', room: 'robot' },
  { name: 'Program', hint: 'A program beside its robot', room: 'program' },
  { name: 'Shape', hint: 'Edit motions', room: 'motion' },
];

const KEY = 'robonewbie-workspace';
const FOCUSABLE = 'button:enabled, input:enabled, select:enabled, a[href], summary, [tabindex]:not([tabindex="-1"])';
const MIN_HIDDEN_PIXELS = 12;

/** In a narrower window the tools would cover the 3D view. */
const WIDE_PIXELS = 900;

export class Workspace {
  /** @type {RoomName} */
  #room = 'field';
  /** The robot shown by both the 3D view and the panels. */
  #robot = 0;
  /** Whether panels are shown next to a replay, and whether the tools are expanded in each view. */
  #kept = { replay: false, tools: { watch: innerWidth > WIDE_PIXELS, understand: false }, ...recall(KEY, {}) };

  /** @param {(room: 'robot' | 'program') => Promise<void> | void} openPanels creates the panels on first use */
  constructor(openPanels) {
    this.openPanels = openPanels;
    this.split = new SplitView(byId('workspace'), panelsOf);
    this.buttons = PRESETS.map((preset) => button(preset.name, preset.hint, () => this.#choose(preset)));
    byId('layouts').append(...this.buttons);
    this.tools = byId('side-fold');
    this.tools.addEventListener('click', () => this.#foldTools());
  }

  /** @param {RoomName} room */
  enter(room) {
    this.#room = room;
    const isProgram = room === 'program';
    const isUnderstand = room === 'robot' || (room === 'replay' && this.#kept.replay);
    byId('robot-room').hidden = !isUnderstand;
    byId('program-room').hidden = !isProgram;
    this.split.preset = isProgram ? 'program' : 'understand';
    this.split.isOn = isUnderstand || isProgram;
    if (this.split.isOn) {
      this.#open(isProgram ? 'program' : 'robot');
    }
    this.#draw();
  }

  /**
   * Makes the 3D view and the panels show the same robot; the most recent choice wins.
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

  /** Marks panels whose content continues below their edge, and makes them focusable. Call periodically. */
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

  /** @param {Preset} preset */
  #choose({ name, room }) {
    if (this.#room === 'replay' && room !== 'motion' && room !== 'program') {
      this.#keep({ replay: name === 'Understand' });
      this.enter('replay');
    } else if (room && !(room === 'field' && this.#room === 'field')) {
      location.hash = `#${room}`;
    }
  }

  #foldTools() {
    const view = this.split.isOn ? 'understand' : 'watch';
    this.#keep({ tools: { ...this.#kept.tools, [view]: !this.#kept.tools[view] } });
    this.#draw();
  }

  /** @param {object} changed */
  #keep(changed) {
    this.#kept = { ...this.#kept, ...changed };
    keep(KEY, this.#kept);
  }

  #draw() {
    const ofRoom = PRESETS.find(({ room }) => room === this.#room && !['field', 'robot'].includes(this.#room));
    const shown = ofRoom?.name ?? (this.split.isOn ? 'Understand' : 'Watch');
    this.buttons.forEach((each, i) => each.setAttribute('aria-pressed', String(PRESETS[i].name === shown)));
    const isUnfolded = this.#kept.tools[this.split.isOn ? 'understand' : 'watch'];
    byId('side').dataset.folded = String(!isUnfolded);
    this.tools.setAttribute('aria-expanded', String(isUnfolded));
    this.tools.title = isUnfolded ? 'Hide camera, game, scenes and puppets' : 'Camera, game, scenes and puppets';
  }
}

/** @returns {Map<PanelName, HTMLElement>} */
function panelsOf() {
  const panels = [
    .../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('#workspace > :not([hidden]) > .side-panel')),
  ];
  return new Map([
    ['picture', byId('field-room')],
    ...panels.map((panel) => /** @type {[PanelName, HTMLElement]} */ ([panel.dataset.panel, panel])),
  ]);
}
