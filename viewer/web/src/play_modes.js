// Play modes: how they read, whose they are, and how the timeline paints them.

/** Splits "kick_in_l" into its action and its side.
 * @param {string} name @returns {{action: string, side: '' | 'left' | 'right'}} */
export function splitPlayMode(name) {
  const match = /^(.*)_(l|r|left|right)$/.exec(name);
  if (!match) return {action: name, side: ''};
  return {action: match[1], side: match[2].startsWith('l') ? 'left' : 'right'};
}

/** "kick in, HELIOS": readable text of a mode.
 * @param {string} name @param {string} left @param {string} right team names @returns {string} */
export function playModeText(name, left, right) {
  if (!name) return 'no play mode';
  const {action, side} = splitPlayMode(name);
  const text = action.replaceAll('_', ' ');
  return side === '' ? text : `${text}, ${side === 'left' ? left : right}`;
}

const kSetPlays = ['kick_off', 'kick_in', 'free_kick', 'corner_kick', 'goal_kick', 'indirect_free_kick', 'penalty_kick', 'penalty_setup', 'penalty_taken'];
const kOffenses = ['offside', 'foul_charge', 'foul_push', 'foul_multiple_attack', 'foul_ballout', 'foul_ball_out', 'back_pass', 'free_kick_fault', 'catch_fault', 'illegal_defense'];

/** @param {string} name @returns {'play' | 'goal' | 'set_play' | 'offense' | 'pause'} */
export function playModeClass(name) {
  const {action, side} = splitPlayMode(name);
  if (action === 'play_on') return 'play';
  if (action === 'goal' || action === 'penalty_score') return 'goal';
  if (side !== '' && kSetPlays.includes(action)) return 'set_play';
  if (kOffenses.includes(action)) return 'offense';
  return 'pause';
}
