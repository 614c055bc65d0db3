// A moment in words.
import {PlayerState} from './player_state.js';
import {playModeText} from './play_modes.js';
import {cycleLabel} from './record.js';
import {kSlots, sideOfSlot, unumOfSlot} from './sides.js';

/** Slot of the enabled player nearest to the ball; -1 if there is none.
 * @param {import('./record.js').MatchRecord} record @param {number} frame @param {'' | 'left' | 'right'} [side] */
export function nearestToBall(record, frame, side = '') {
  let nearest = -1;
  let shortest = Infinity;
  for (let slot = 0; slot < kSlots; ++slot) {
    if (side !== '' && sideOfSlot(slot) !== side) continue;
    if (!(record.column('state')[slot][frame] & PlayerState.enabled)) continue;
    const distance = distanceToBall(record, frame, slot);
    if (distance < shortest) {
      shortest = distance;
      nearest = slot;
    }
  }
  return nearest;
}

/** @param {import('./record.js').MatchRecord} record @param {number} frame @param {number} slot @returns {number} meters */
export function distanceToBall(record, frame, slot) {
  const dx = record.column('x')[slot][frame] - record.column('ball_x')[0][frame];
  const dy = record.column('y')[slot][frame] - record.column('ball_y')[0][frame];
  return Math.hypot(dx, dy);
}

/** "HELIOS 7". @param {import('./record.js').MatchRecord} record @param {number} frame @param {number} slot */
export function playerName(record, frame, slot) {
  const team = record.teamsAt(frame)[sideOfSlot(slot) === 'left' ? 0 : 1];
  return `${team.name || sideOfSlot(slot)} ${unumOfSlot(slot)}`;
}

/** "3 to 1", with penalties if there were any. @param {import('./record.js').MatchRecord} record @param {number} frame */
export function scoreText(record, frame) {
  const [left, right] = record.teamsAt(frame);
  const shootOut = left.scored + left.missed + right.scored + right.missed > 0;
  return `${left.score} to ${right.score}${shootOut ? `, penalties ${left.scored} to ${right.scored}` : ''}`;
}

/** Where a point of the pitch is, in words: "left penalty area, 12.3 m from the center line". */
function placeText(x, y) {
  const half = x < 0 ? 'left' : 'right';
  const third = Math.abs(x) > 36 && Math.abs(y) < 20.16 ? `${half} penalty area` : Math.abs(x) < 9 ? 'middle of the pitch' : `${half} half`;
  const flank = y < -20.16 ? ', upper flank' : y > 20.16 ? ', lower flank' : '';
  return `${third}${flank}, x ${x.toFixed(1)}, y ${y.toFixed(1)}`;
}

/** The moment for people who do not see it: clock, mode, score, ball, nearest players.
 * @param {import('./record.js').MatchRecord} record @param {number} frame @param {number[]} [selected] slots */
export function momentText(record, frame, selected = []) {
  const [left, right] = record.teamsAt(frame);
  const parts = [
    `Cycle ${cycleLabel(record, frame)}, ${playModeText(record.modeName(frame), left.name, right.name)}`,
    `${left.name || 'left'} against ${right.name || 'right'}: ${scoreText(record, frame)}`,
    `Ball: ${placeText(record.column('ball_x')[0][frame], record.column('ball_y')[0][frame])}`,
  ];
  const nearest = nearestToBall(record, frame);
  if (nearest >= 0) parts.push(`Nearest: ${playerName(record, frame, nearest)}, ${distanceToBall(record, frame, nearest).toFixed(1)} m`);
  for (const slot of selected) {
    const place = placeText(record.column('x')[slot][frame], record.column('y')[slot][frame]);
    parts.push(`${playerName(record, frame, slot)}: ${place}, ${distanceToBall(record, frame, slot).toFixed(1)} m from the ball`);
  }
  return `${parts.join('. ')}.`;
}
