// Player slots: 0 to 10 are the left team's players 1 to 11, 11 to 21 those of the right team.

export const kSlots = 22;
export const kPlayersPerTeam = 11;

/** @param {number} slot @returns {'left' | 'right'} */
export function sideOfSlot(slot) {
  return slot < kPlayersPerTeam ? 'left' : 'right';
}

/** @param {number} slot @returns {number} uniform number, 1 to 11 */
export function unumOfSlot(slot) {
  return (slot % kPlayersPerTeam) + 1;
}

/** @param {string} side 'left' or 'right' @param {number} unum @returns {number} slot, -1 if there is none */
export function slotOf(side, unum) {
  if (!(unum >= 1 && unum <= kPlayersPerTeam)) return -1;
  return (side === 'right' ? kPlayersPerTeam : 0) + unum - 1;
}

/** @param {number} slot @returns {string} "l7", "r11" */
export function shortNameOfSlot(slot) {
  return `${slot < kPlayersPerTeam ? 'l' : 'r'}${unumOfSlot(slot)}`;
}

/** @param {string} text "l7" @returns {number} slot, -1 if the text is not a player */
export function slotOfShortName(text) {
  const match = /^([lr])(\d{1,2})$/.exec(text);
  return match ? slotOf(match[1] === 'r' ? 'right' : 'left', Number(match[2])) : -1;
}
