/** Camera selection and referee commands. */
import { CAMERAS } from '../field/camera-controller.js';
import { BALL_RADIUS, ballRadiusOf } from '../state/ball-radius.js';
import { playModeText } from '../state/play-mode.js';
import { button, byId, check, choice, element, setEntries } from './elements.js';
import { keep, recall } from './memory.js';

/**
 * @typedef {import('../state/studio-state.js').StudioState} StudioState
 * @typedef {import('../field/camera-controller.js').CameraController} CameraController
 * @typedef {import('../field/camera-controller.js').CameraMode} CameraMode
 * @typedef {{names: boolean, trail: boolean, shadows?: boolean}} Picture options of the picture; by default, shadows depend on the quality
 * level
 */

const PICTURE_KEY = 'robonewbie-picture';

/**
 * @param {CameraController} camera
 * @param {object} options
 * @param {(mode: CameraMode) => void} options.choose
 * @param {import('../field/field-view.js').FieldView} options.view
 * @param {(shown: Picture) => void} options.show
 * @returns {(state: StudioState) => void} function that updates the camera buttons
 */
export function cameraPanel(camera, options) {
  const buttons = CAMERAS.map(({ mode, name, hint }, i) => {
    const made = button(name, `${hint} (${i + 1})`, () => options.choose(mode));
    made.dataset.camera = mode;
    return made;
  });
  const grid = element('div', { class: 'grid' }, ...buttons);
  const { shadows, names, trail } = pictureChecks(options.show);
  shadows.label.hidden = !options.view.canShade;
  byId('cameras').append(element('h2', {}, 'Camera'), grid, shadows.label, names.label, trail.label);
  return (state) => {
    shadows.box.checked = options.view.realShadows;
    const robots = state.scene?.robots.length ?? 0;
    for (const each of buttons) {
      const mode = each.dataset.camera;
      each.setAttribute('aria-pressed', String(mode === camera.mode));
      each.hidden = robots === 0 && (mode === 'follow' || mode === 'eye');
    }
  };
}

/** Creates check boxes whose state is stored in the browser. @param {(shown: Picture) => void} show */
function pictureChecks(show) {
  /** @type {Picture} */
  const shown = { names: true, trail: true, ...recall(PICTURE_KEY, {}) };
  const set = (/** @type {keyof Picture} */ what, /** @type {boolean} */ on) => {
    shown[what] = on;
    keep(PICTURE_KEY, shown);
    show(shown);
  };
  const shadows = check('shadows', 'Real shadows', 'Shadows cast by the sun', (on) => set('shadows', on));
  const names = check('names', 'Names', 'Team and number above each robot', (on) => set('names', on));
  const trail = check('trail', 'Trail of the ball', 'Path of the ball over the last three seconds', (on) =>
    set('trail', on),
  );
  names.box.checked = shown.names;
  trail.box.checked = shown.trail;
  show(shown);
  return { shadows, names, trail };
}

/**
 * @param {(command: object) => void} send
 * @returns {(state: StudioState) => void} function that updates the referee's buttons
 */
export function trainerPanel(send) {
  const modes = choice({ id: 'play-mode', 'aria-label': 'Play mode', title: 'Sets the play mode' }, [], (mode) =>
    send({ do: 'playMode', mode }),
  );
  const panel = byId('trainer');
  let radius = BALL_RADIUS;
  const buttons = trainerButtons(send, () => radius);
  panel.append(element('h2', {}, 'Game'), element('div', { class: 'grid' }, ...buttons), modes);
  let listed = '';
  return ({ scene, frame }) => {
    panel.hidden = !scene || !frame;
    if (!scene || !frame) {
      return;
    }
    radius = ballRadiusOf(scene);
    modes.hidden = scene.match === false;
    const names = scene.playModes.join() + scene.teams.left + scene.teams.right;
    if (names !== listed) {
      listed = names;
      setEntries(
        modes,
        scene.playModes.map((mode) => [mode, playModeText(mode, scene.teams)]),
      );
    }
    if (document.activeElement !== modes) {
      modes.value = scene.playModes[frame.playMode];
    }
  };
}

/** @param {(command: object) => void} send @param {() => number} radius of the ball, metres */
function trainerButtons(send, radius) {
  const centre = () => send({ do: 'placeBall', x: 0, y: 0, z: radius() });
  return [
    button('◀ Kick off', 'The left team kicks off (K)', () => send({ do: 'kickOff', side: 'left' })),
    button('Kick off ▶', 'The right team kicks off (L)', () => send({ do: 'kickOff', side: 'right' })),
    button('Drop ball', 'Drops the ball where it is (B)', () => send({ do: 'dropBall' }), { id: 'drop-ball' }),
    button('Ball to centre', 'Puts the ball on the centre spot', centre),
  ];
}
