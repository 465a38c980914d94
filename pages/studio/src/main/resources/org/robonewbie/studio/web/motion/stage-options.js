/** Display options of the motion room's 3D view. */
import { button, check, element } from '../panels/elements.js';

const WATCHING_HINT =
  'On: the robot of the trial, with the plan as a ghost. Off: the plan, with the robot as an orange ghost.';
const UPRIGHT_HINT = 'Keeps the torso upright instead of laying the lower sole flat on the ground';

/**
 * @param {object} room
 * @param {(on: boolean) => void} room.setGhosts
 * @param {(on: boolean) => void} room.setUpright
 * @param {(azimuthDegrees: number, elevationDegrees: number) => void} room.look
 * @param {(on: boolean) => void} room.setWatching
 */
export function stageOptions(room) {
  const ghosts = check('ghosts', 'Ghosts', 'Shows the keyframes before (blue) and after (orange)', room.setGhosts);
  ghosts.box.checked = true;
  const watching = check('watching', 'With physics', WATCHING_HINT, room.setWatching);
  const upright = check('upright', 'Torso upright', UPRIGHT_HINT, room.setUpright);
  const torsoHint = element('span', {}, ' · drag the torso: feet stay in place');
  const options = element(
    'div',
    { class: 'stage-options' },
    watching.label,
    ghosts.label,
    upright.label,
    button('Front', 'View from the front', () => room.look(62, 12)),
    button('Side', 'View from the side', () => room.look(0, 8)),
  );
  return {
    options,
    /** The mouse help of the 3D view. */
    hint: element('p', { class: 'hint' }, 'Drag a limb · Shift: whole arm or leg follows', torsoHint),
    /** @param {import('../state/motion/editor-state.js').EditorState} state */
    draw(state) {
      upright.label.hidden = torsoHint.hidden = !state.body.isNao;
      watching.label.hidden = state.trial === undefined;
      watching.box.checked = state.watching;
    },
  };
}
