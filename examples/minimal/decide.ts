// The team's decisions: the place for your own ideas.
import * as actions from './actions';
import { GOAL, point } from './situation';
import { CoachActions } from './wire/protos/CoachActions';
import { PlayerActions } from './wire/protos/PlayerActions';
import { State__Output } from './wire/protos/State';
import { TrainerActions } from './wire/protos/TrainerActions';

/** The actions of one player for one cycle; the first possible body action is executed. */
export function decide(state: State__Output): PlayerActions {
  const world = state.world_model!;
  const self = world.self!;
  if (world.game_mode_type !== 'PlayOn') return { actions: [actions.setPlay()] };
  if (self.is_goalie) return { actions: [actions.goalie()] };
  if (self.is_kickable) {
    const shown = [
      actions.showLine(point(world.ball!.position), GOAL, 'yellow'),
      actions.showText('has the ball'),
    ];
    return { actions: [...shown, actions.smartKick(GOAL, 3, 0.1, 3), actions.watchBall(0)] };
  }
  return { actions: [actions.basicMove()] };
}

export function decideAsCoach(_state: State__Output): CoachActions {
  return { actions: [actions.substitute()] };
}

export function decideAsTrainer(_state: State__Output): TrainerActions {
  return {};
}
