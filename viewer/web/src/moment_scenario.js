// A moment of the match as a scenario of `cls test`.
import {PlayerState} from './player_state.js';
import {cycleLabel} from './record.js';
import {kPlayersPerTeam, shortNameOfSlot, sideOfSlot, unumOfSlot} from './sides.js';

const kScenarioSteps = 50;

/** @param {number} value */
function rounded(value) {
  return Number(value.toFixed(4));
}

/** @param {string} x @param {string} y columns */
function pair(record, x, y, slot, frame) {
  return [rounded(record.column(x)[slot][frame]), rounded(record.column(y)[slot][frame])];
}

function playersOf(record, frame, first) {
  const players = {};
  for (let slot = first; slot < first + kPlayersPerTeam; ++slot) {
    const state = record.column('state')[slot][frame];
    if (!(state & PlayerState.enabled)) continue;
    players[unumOfSlot(slot)] = {
      at: pair(record, 'x', 'y', slot, frame),
      body: rounded(record.column('body')[slot][frame]),
      velocity: pair(record, 'vx', 'vy', slot, frame),
      stamina: rounded(record.column('stamina')[slot][frame]),
    };
  }
  return players;
}

/** A scenario file that starts with this moment and expects an action of a player. Its sides are those of the match, where the page knows
 * them.
 * @param {import('./record.js').MatchRecord} record @param {number} frame @param {number} slot @returns {string} JSON */
export function scenarioOfMoment(record, frame, slot) {
  const side = sideOfSlot(slot);
  const [left, right] = record.sides ?? ['mock', 'mock'];
  const unknown = record.sides ? '' : ' The page does not know the Playmakers: cls test FILE --against SIDE.';
  const scenario = {
    about: `${shortNameOfSlot(slot)} in cycle ${cycleLabel(record, frame)}.${unknown}`,
    mode: record.modeName(frame),
    ball: {at: pair(record, 'ball_x', 'ball_y', 0, frame), velocity: pair(record, 'ball_vx', 'ball_vy', 0, frame)},
    left: {playmaker: left, players: playersOf(record, frame, 0)},
    right: {playmaker: right, players: playersOf(record, frame, kPlayersPerTeam)},
    under_test: side,
    steps: kScenarioSteps,
    expect: [{actions: '*', side, unum: unumOfSlot(slot)}],
  };
  const points = /\[\n +(-?[\d.]+),\n +(-?[\d.]+)\n +\]/g;
  return `${JSON.stringify(scenario, null, 2).replace(points, '[$1, $2]')}\n`;
}
