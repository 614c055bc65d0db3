// The team's decisions: the place for your own ideas.
import * as actions from './actions.js';
import { GOAL, point } from './situation.js';

/** The actions of one player for one cycle; the first possible body action is executed. */
export function decide(state) {
  const world = state.world_model;
  const self = world.self;
  if (world.game_mode_type !== 'PlayOn') return { actions: [actions.setPlay()] };
  if (self.is_goalie) return { actions: [actions.goalie()] };
  if (self.is_kickable) {
    const shown = [
      actions.showLine(point(world.ball.position), GOAL, 'yellow'),
      actions.showText('has the ball'),
    ];
    return { actions: [...shown, actions.smartKick(GOAL, 3, 0.1, 3), actions.watchBall(0)] };
  }
  return { actions: [actions.basicMove()] };
}

export function decideAsCoach(_state) {
  return { actions: [actions.substitute()] };
}

export function decideAsTrainer(_state) {
  return {};
}
