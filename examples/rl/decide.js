// The team's decisions: a policy chooses what to do with the ball, the proxy does the rest.
import { readFileSync } from 'node:fs';
import * as actions from './actions.js';
import { GOAL, Situation, distance } from './situation.js';

/** The weights of each action. */
const POLICY = readFileSync(process.env.POLICY || 'policy.txt', 'utf8').split('\n')
  .filter((line) => line.trim() !== '' && !line.startsWith('#'))
  .map((line) => line.trim().split(/\s+/))
  .map(([action, ...weights]) => ({ action, weights: weights.map(Number) }));

/** What the policy sees, each about 0 to 1: bias, goal, room, lane, own_half. */
function features(now) {
  const ahead = { x: now.me.x + 8, y: now.me.y };
  return [1, Math.max(0, 1 - distance(now.ball, GOAL) / 50), Math.min(now.room(now.ball), 10) / 10,
    Math.min(Math.max(now.lane(now.me, ahead), 0), 4) / 4, now.ball.x < 0 ? 1 : 0];
}

function action(name) {
  switch (name) {
    case 'shoot': return actions.smartKick(GOAL, 3, 2, 2);
    case 'pass': return {
      helios_offensive_planner: {
        direct_pass: true, lead_pass: true, through_pass: true, max_depth: 1,
      },
    };
    case 'dribble': return actions.dribble(GOAL, 90, 4);
    case 'clear': return actions.clearBall();
    default: return actions.holdBall(GOAL);
  }
}

/** All actions, the one with the highest score first: the first possible one is executed. */
function withBall(now) {
  const seen = features(now);
  const score = (row) => row.weights.reduce((sum, weight, i) => sum + weight * seen[i], 0);
  const ranked = POLICY.map((row) => ({ name: row.action, score: score(row) }))
    .sort((a, b) => b.score - a.score);
  return [...ranked.map((one) => action(one.name)), actions.watchBall(0)];
}

/** The actions of one player for one cycle. */
export function decide(state) {
  const now = new Situation(state);
  if (now.world.is_penalty_kick_mode) return { actions: [actions.penalty()] };
  if (now.world.game_mode_type !== 'PlayOn') return { actions: [actions.setPlay()] };
  if (now.self.is_goalie) return { actions: [actions.goalie()] };
  if (now.self.is_kickable) return { actions: withBall(now) };
  return { actions: [actions.basicMove(), actions.watchBall(1)] };
}

export function decideAsCoach(_state) {
  return { actions: [actions.substitute(), actions.sayPlayerTypes()] };
}

export function decideAsTrainer(_state) {
  return {};
}
