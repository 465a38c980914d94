/** Describes match events in sentences. Pure. */

/** @type {Record<string, string>} */
const FOULS = {
  CROWDING: 'too many robots of one team near the ball',
  TOUCHING: 'too many robots touching each other',
  ILLEGAL_DEFENCE: 'too many defenders in the penalty area',
  ILLEGAL_ATTACK: 'too many attackers in the penalty area',
  INCAPABLE: 'lies on the ground for too long',
  ILLEGAL_KICK_OFF: 'illegal kick-off',
  CHARGING: 'runs into an opponent',
  SELF_COLLISION: 'its own limbs collide',
  BALL_HOLDING: 'keeps the ball for too long',
  DOUBLE_TOUCHING: 'touches the ball twice',
  HAND_FOUL: 'plays the ball with an arm',
};

/**
 * @param {string} event event in the format of recordings, such as `foul CHARGING left 3`
 * @param {{left: string, right: string}} teams
 * @returns {string} a sentence, empty for events shown elsewhere
 */
export function matchEventText(event, teams) {
  const [kind, first, side, number] = event.split(' ');
  if (kind === 'goal') {
    return `Goal for ${event.split(' ').slice(2).join(' ') || first}`;
  }
  if (kind !== 'foul') {
    return '';
  }
  const team = (side === 'left' ? teams.left : teams.right) || side;
  return `Foul: ${team} ${number} ${FOULS[first] ?? first.toLowerCase().replaceAll('_', ' ')}`;
}
