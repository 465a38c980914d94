/** What one can choose at the picture of the motion room. */
import { button, check, element } from '../panels/elements.js';

const UPRIGHT_HINT = 'Keeps the torso upright instead of laying the lower sole flat on the ground';

/**
 * @param {object} room
 * @param {(on: boolean) => void} room.setGhosts
 * @param {(on: boolean) => void} room.setUpright
 * @param {(azimuthDegrees: number, elevationDegrees: number) => void} room.look
 */
export function stageOptions(room) {
  const ghosts = check('ghosts', 'Ghosts', 'Shows the keyframes before (blue) and after (orange)', room.setGhosts);
  ghosts.box.checked = true;
  return element(
    'div',
    { class: 'stage-options' },
    element('p', { class: 'hint' }, 'Drag a limb · Shift: whole arm or leg follows · drag the torso: feet stay'),
    ghosts.label,
    check('upright', 'Torso upright', UPRIGHT_HINT, room.setUpright).label,
    button('Front', 'Look from the front', () => room.look(62, 12)),
    button('Side', 'Look from the side', () => room.look(0, 8)),
  );
}
