// The team's decisions by the behaviors of the proxy: which of them, and with which values.
import * as actions from './actions.js';
import { GOAL, distance, point } from './situation.js';

const DEFENDERS = [2, 3, 4, 5]; // uniform numbers
const SHOT = 20; // meters to the goal

/** The actions of one player for one cycle; the first possible body action is executed. */
export function decide(state) {
  const world = state.world_model;
  const self = world.self;
  if (world.is_penalty_kick_mode) return { actions: [actions.penalty()] };
  if (world.game_mode_type !== 'PlayOn') return { actions: [actions.setPlay()] };
  if (self.is_goalie) return { actions: [actions.goalie()] };
  if (self.is_kickable) {
    const defends = DEFENDERS.includes(self.uniform_number);
    const near = distance(point(world.ball.position), GOAL) < SHOT;
    const shots = near ? [actions.shoot(), actions.smartKick(GOAL, 3, 2, 2)] : [actions.shoot()];
    return {
      actions: [...shots, plan(defends), actions.holdBall(GOAL), actions.watchBall(0)],
    };
  }
  return { actions: [actions.basicMove(), actions.watchBall(1)] };
}

/** Searches chains of passes and dribbles. Defenders pass rather than dribble. */
function plan(defends) {
  return {
    helios_offensive_planner: {
      direct_pass: true, lead_pass: true, through_pass: true, short_dribble: true,
      long_dribble: !defends, cross: !defends, simple_pass: true, simple_dribble: true,
      simple_shoot: true, evaluation: evaluation(defends),
    },
  };
}

/** Factors by the first action of a chain, and costs of opponents at 0, 1, 2, ... meters. */
function evaluation(defends) {
  return {
    effectors: {
      action_type_effector: {
        direct_pass: defends ? 1.2 : 1, lead_pass: 1, through_pass: 1.1,
        short_dribble: defends ? 0.8 : 1, long_dribble: 1, cross: 1, hold: 1,
      },
      opponent_effector: { negetive_effect_by_distance: [-8, -5, -2] },
    },
  };
}

export function decideAsCoach(_state) {
  return { actions: [actions.substitute(), actions.sayPlayerTypes()] };
}

export function decideAsTrainer(_state) {
  return {};
}
