// Teams that are JavaScript: objects with the functions of `decide.js` of a JavaScript project.
import { Messages } from './messages.js';

/** The function of a team that makes a decision, and the type of its reply. */
const DECISIONS = {
  GetPlayerActions: ['decide', 'protos.PlayerActions'],
  GetCoachActions: ['decideAsCoach', 'protos.CoachActions'],
};

/** For Engine.start(): calls the functions of a team with objects, and gives their replies as bytes. A team with a function
 * `answer` has the bytes of a State as they are. */
export function makeDecider(team, messages) {
  if (team.answer) return (rpc, state) => team.answer(rpc, state);
  return (rpc, state) => {
    const [name, type] = DECISIONS[rpc];
    if (team[name] === undefined) return undefined;
    return messages.encode(type, team[name](messages.decode('protos.State', state)));
  };
}

/** Starts a match whose sides may be teams as well as texts. */
export function startMatch(engine, { left, right, ...setup }) {
  const teams = [left, right];
  teams.forEach((team, side) => check(team, ['left', 'right'][side]));
  const messages = new Messages(engine.schema());
  const isTeam = (team) => typeof team !== 'string';
  const sides = teams.map((team) => (isTeam(team) ? 'function' : team));
  const deciders = teams.map((team) => (isTeam(team) ? makeDecider(team, messages) : null));
  return engine.start({ left: sides[0], right: sides[1], ...setup }, deciders);
}

function check(team, side) {
  if (typeof team === 'string' || typeof (team?.decide ?? team?.answer) === 'function') return;
  throw new TypeError(`${side} must be a side such as 'mock:planner', or an object with a function decide`);
}
