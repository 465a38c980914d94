/** Which camera looks, and what the referee can be told. */
import { CAMERAS } from '../field/camera-desk.js';
import { playModeText } from '../state/play-mode.js';
import { button, byId, element } from './elements.js';

/**
 * @typedef {import('../state/studio-state.js').StudioState} StudioState
 * @typedef {import('../field/camera-desk.js').CameraDesk} CameraDesk
 * @typedef {import('../field/camera-desk.js').CameraMode} CameraMode
 */

/**
 * @param {CameraDesk} desk
 * @param {object} options
 * @param {(mode: CameraMode) => void} options.choose
 * @param {boolean} options.shadows
 * @param {(on: boolean) => void} options.setShadows
 * @returns {(state: StudioState) => void} draws the camera buttons
 */
export function cameraPanel(desk, options) {
  const buttons = CAMERAS.map(({ mode, name, hint }, i) => {
    const made = button(name, `${hint} (${i + 1})`, () => options.choose(mode));
    made.dataset.camera = mode;
    return made;
  });
  const shadows = element('input', { type: 'checkbox', id: 'shadows' });
  shadows.checked = options.shadows;
  shadows.addEventListener('change', () => options.setShadows(shadows.checked));
  byId('cameras').append(
    element('h2', {}, 'Camera'),
    element('div', { class: 'grid' }, ...buttons),
    element('label', { class: 'check' }, shadows, 'Real shadows'),
  );
  return (state) => {
    const robots = state.scene?.robots.length ?? 0;
    for (const each of buttons) {
      const mode = each.dataset.camera;
      each.setAttribute('aria-pressed', String(mode === desk.mode));
      each.hidden = robots === 0 && (mode === 'follow' || mode === 'eye');
    }
  };
}

/**
 * @param {(command: object) => void} send
 * @returns {(state: StudioState) => void} draws the referee's buttons
 */
export function trainerPanel(send) {
  const kickOffLeft = button('◀ Kick off', 'The left team begins (K)', () => send({ do: 'kickOff', side: 'left' }));
  const kickOffRight = button('Kick off ▶', 'The right team begins (L)', () => send({ do: 'kickOff', side: 'right' }));
  const drop = button('Drop ball', 'The ball is free where it lies (B)', () => send({ do: 'dropBall' }));
  drop.id = 'drop-ball';
  const centre = button('Ball to centre', 'Puts the ball on the centre spot', () =>
    send({ do: 'placeBall', x: 0, y: 0, z: 0.042 }),
  );
  const modes = element('select', { id: 'play-mode', 'aria-label': 'Play mode', title: 'Sets any play mode' });
  modes.addEventListener('change', () => send({ do: 'playMode', mode: modes.value }));
  const panel = byId('trainer');
  panel.append(
    element('h2', {}, 'Game'),
    element('div', { class: 'grid' }, kickOffLeft, kickOffRight, drop, centre),
    modes,
  );
  let listed = '';
  return (state) => {
    const { scene, frame } = state;
    panel.hidden = !scene || !frame;
    if (!scene || !frame) {
      return;
    }
    const names = scene.playModes.join() + scene.teams.left + scene.teams.right;
    if (names !== listed) {
      listed = names;
      const options = scene.playModes.map((mode) => element('option', { value: mode }, playModeText(mode, scene.teams)));
      modes.replaceChildren(...options);
    }
    if (document.activeElement !== modes) {
      modes.value = scene.playModes[frame.playMode];
    }
  };
}
