/** Remote control of a robot: keys make it walk and kick, sliders move its joints. The robot needs no program. */
import { buttonsOfPad, PAD_TEXT, walkOfPad } from '../state/gamepad.js';
import { PUPPET_KEYS, puppetKey, turned, walkOf } from '../state/puppet.js';
import { isTyping } from './keys.js';
import { button, byId, element, setText } from './elements.js';

/**
 * @typedef {import('../state/studio-state.js').StudioState} StudioState
 * @typedef {import('../live/state-frame.js').Player} Player
 */

const STANDING = JSON.stringify({ forward: 0, left: 0, turn: 0 });

export class PuppetPanel {
  /**
   * @param {object} world
   * @param {() => StudioState} world.now
   * @param {() => number} world.chosen index of the followed robot
   * @param {(index: number) => void} world.choose
   * @param {() => boolean} world.isHere whether the field is visible
   * @param {(command: object) => void} world.send
   */
  constructor(world) {
    this.world = world;
    /** @type {Set<string>} */
    this.held = new Set();
    /** @type {[number, number]} */
    this.gaze = [0, 0];
    this.waitsForNew = 0;
    /** Buttons of the gamepad that are pressed. @type {Set<number>} */
    this.padDown = new Set();
    this.padWalk = '';
    this.pad = element('p', { class: 'faint', id: 'gamepad', hidden: '' }, PAD_TEXT);
    this.add = button('Add a puppet', 'A robot under your control', () => this.#add(), { id: 'add-puppet' });
    const remove = () => this.#order({ do: 'removePuppet' });
    this.away = button('Remove', 'Removes this puppet from the pitch', remove, { id: 'remove-puppet' });
    this.stand = button('Stand', 'Releases all joints and stands up', () =>
      this.#order({ do: 'perform', motion: 'stand' }),
    );
    this.hint = element('p', { class: 'faint' });
    this.keys = element(
      'dl',
      { class: 'puppet-keys' },
      ...PUPPET_KEYS.map(({ shown, text }) =>
        element('div', {}, element('dt', {}, element('kbd', {}, shown)), element('dd', {}, text)),
      ),
    );
    this.sliders = element('div', { class: 'puppet-joints' });
    /** @type {HTMLInputElement[]} */
    this.inputs = [];
    this.joints = element('details', { id: 'puppet-joints' }, element('summary', {}, 'Joints'), this.sliders);
    this.help = element('details', { id: 'puppet-keys' }, element('summary', {}, 'Keys'), this.keys);
    this.tools = element('div', { class: 'grid' }, this.stand, this.away);
    this.joints.addEventListener('toggle', () => this.joints.open && this.#showJoints());
    byId('puppet').append(
      element('h2', {}, 'Puppet'),
      this.add,
      this.hint,
      this.pad,
      this.tools,
      this.help,
      this.joints,
    );
    document.addEventListener('keydown', (event) => this.#press(event), { capture: true });
    document.addEventListener('keyup', (event) => this.#release(event.key.toLowerCase()));
    window.addEventListener('blur', () => this.#releaseAll());
  }

  /** @returns {Player | undefined} the followed puppet */
  get player() {
    const player = this.world.now().scene?.robots[this.world.chosen()];
    return player?.puppet && player.side ? player : undefined;
  }

  /** @param {StudioState} state */
  draw(state) {
    const { scene, frame } = state;
    byId('puppet').hidden = !scene?.puppets || !frame || !this.world.isHere();
    if (!scene || !frame) {
      return;
    }
    this.#chooseNew(scene.robots);
    const { player } = this;
    const others = scene.robots.some(({ puppet }) => puppet);
    setText(
      this.hint,
      player
        ? `You are steering ${player.team} ${player.number}: W A S D to walk, F and G to kick.`
        : others
          ? 'Click a puppet to steer it.'
          : 'Walk, kick and move joints without writing code.',
    );
    for (const part of [this.tools, this.help, this.joints]) {
      part.hidden = !player;
    }
    if (player && this.joints.open) {
      this.#drawJoints(scene.models[player.type].hinges, frame.robots[this.world.chosen()].degrees);
    }
  }

  /** Applies the first gamepad's input; call once per animation frame. */
  readGamepad() {
    const pad = navigator.getGamepads?.().find((each) => each?.connected);
    this.pad.hidden = !pad;
    if (!pad || !this.player || !this.world.isHere()) {
      return;
    }
    const walk = walkOfPad(pad);
    const wanted = JSON.stringify(walk);
    if (this.padWalk !== wanted && !(this.padWalk === '' && wanted === STANDING)) {
      this.padWalk = wanted;
      this.#order({ do: 'walk', ...walk });
    }
    const { down, motion } = buttonsOfPad(pad, this.padDown);
    this.padDown = down;
    if (motion) {
      this.#order({ do: 'perform', motion });
    }
  }

  #add() {
    this.waitsForNew = (this.world.now().scene?.robots.filter(({ puppet }) => puppet).length ?? 0) + 1;
    this.world.send({ do: 'addPuppet', side: 'left' });
  }

  /** Selects the robot that the user has just added, once it has joined. @param {Player[]} robots */
  #chooseNew(robots) {
    const puppets = robots.map((_, i) => i).filter((i) => robots[i].puppet);
    if (this.waitsForNew > 0 && puppets.length >= this.waitsForNew) {
      this.waitsForNew = 0;
      this.world.choose(puppets[puppets.length - 1]);
    }
  }

  /** @param {object} order */
  #order(order) {
    const { player } = this;
    if (player) {
      this.world.send({ ...order, side: player.side, number: player.number });
    }
  }

  /** @param {KeyboardEvent} event */
  #press(event) {
    const known = puppetKey(event.key);
    if (known && this.player && this.world.isHere() && isPlain(event)) {
      event.preventDefault();
      event.stopPropagation();
      this.#execute(known, event.repeat);
    }
  }

  /** @param {NonNullable<ReturnType<typeof puppetKey>>} known @param {boolean} isRepeated */
  #execute(known, isRepeated) {
    if (known.walk && !this.held.has(known.key)) {
      this.held.add(known.key);
      this.#order({ do: 'walk', ...walkOf(this.held) });
    } else if (known.motion && !isRepeated) {
      this.#order({ do: 'perform', motion: known.motion });
    } else if (known.look) {
      this.gaze = turned(this.gaze, known.look);
      this.#order({ do: 'look', yaw: this.gaze[0], pitch: this.gaze[1] });
    }
  }

  /** @param {string} key */
  #release(key) {
    if (this.held.delete(key)) {
      this.#order({ do: 'walk', ...walkOf(this.held) });
    }
  }

  #releaseAll() {
    if (this.held.size > 0) {
      this.held.clear();
      this.#order({ do: 'walk', ...walkOf(this.held) });
    }
  }

  /** Shows the joint sliders below the other controls and scrolls them into view. */
  #showJoints() {
    this.joints.scrollIntoView({ block: 'start' });
  }

  /** @param {import('../state/kinematics.js').RobotModel['hinges']} hinges @param {ArrayLike<number>} degrees */
  #drawJoints(hinges, degrees) {
    if (this.inputs.length !== hinges.length) {
      this.inputs = hinges.map((hinge) => this.#slider(hinge));
      this.sliders.replaceChildren(
        ...hinges.map((hinge, i) =>
          element(
            'label',
            {},
            element('span', {}, hinge.joint.toLowerCase().replaceAll('_', ' ')),
            this.inputs[i],
            element('output'),
          ),
        ),
      );
      this.#showJoints();
    }
    this.inputs.forEach((input, i) => {
      if (document.activeElement !== input) {
        input.value = String(degrees[i]);
      }
      setText(/** @type {Element} */ (input.nextElementSibling), `${degrees[i].toFixed(0)}°`);
    });
  }

  /** @param {import('../state/kinematics.js').RobotModel['hinges'][number]} hinge */
  #slider({ joint, minDegrees, maxDegrees }) {
    const input = element('input', {
      type: 'range',
      min: String(minDegrees),
      max: String(maxDegrees),
      step: '1',
      'data-joint': joint,
      'aria-label': joint.toLowerCase().replaceAll('_', ' '),
    });
    input.addEventListener('input', () => this.#order({ do: 'hold', joint, degrees: Number(input.value) }));
    input.addEventListener('pointerup', () => input.blur());
    return input;
  }
}

/** @param {KeyboardEvent} event @returns {boolean} whether a key is pressed without modifiers and outside of fields and dialogs */
function isPlain(event) {
  const hasModifier = event.ctrlKey || event.metaKey || event.altKey;
  return (
    !hasModifier && !isTyping(/** @type {HTMLElement} */ (event.target)) && !document.querySelector('dialog[open]')
  );
}
