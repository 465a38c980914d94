/** Display names of play modes. */

/** @type {Object<string, string>} */
const PLAIN = {
  BeforeKickOff: 'Before kick-off',
  PlayOn: 'Play on',
  GameOver: 'Game over',
};

/** @type {Object<string, string>} */
const OF_A_TEAM = {
  kickoff: 'Kick-off',
  kickin: 'Kick-in',
  corner_kick: 'Corner kick',
  goal_kick: 'Goal kick',
  offside: 'Offside',
  goal: 'Goal',
  free_kick: 'Free kick',
  direct_free_kick: 'Direct free kick',
  pass: 'Pass',
};

/**
 * Formats a play mode.
 *
 * @param {string} name SimSpark's name, such as `KickOff_Left`
 * @param {{left: string, right: string}} teams team names, empty before the teams have joined
 * @returns {string} text such as `Kick-off · Blue Newbies`
 */
export function playModeText(name, teams) {
  const match = /^(.*)_(left|right)$/i.exec(name);
  if (!match) {
    return PLAIN[name] ?? name;
  }
  const side = match[2].toLowerCase() === 'left' ? 'left' : 'right';
  const what = OF_A_TEAM[match[1].toLowerCase()] ?? match[1];
  return `${what} · ${teams[side] || side}`;
}
