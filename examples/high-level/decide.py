"""The team's decisions by the behaviors of the proxy: which of them, and with which values."""
from __future__ import annotations

import actions
from cls_playmaker import proto as pb
from situation import GOAL, distance, point

DEFENDERS = range(2, 6)  # uniform numbers
SHOT = 20.0  # meters to the goal


def decide(state: pb.State) -> pb.PlayerActions:
    """The actions of one player for one cycle; the first possible body action is executed."""
    world = state.world_model
    if world.is_penalty_kick_mode:
        return pb.PlayerActions(actions=[actions.penalty()])
    if world.game_mode_type != pb.PlayOn:
        return pb.PlayerActions(actions=[actions.set_play()])
    if world.self.is_goalie:
        return pb.PlayerActions(actions=[actions.goalie()])
    if world.self.is_kickable:
        defends = world.self.uniform_number in DEFENDERS
        near = distance(point(world.ball.position), GOAL) < SHOT
        shots = [actions.shoot()] + ([actions.smart_kick(GOAL, 3.0, 2.0, 2)] if near else [])
        return pb.PlayerActions(actions=shots + [
            plan(defends), actions.hold_ball(GOAL), actions.watch_ball(0)])
    return pb.PlayerActions(actions=[actions.basic_move(), actions.watch_ball(1)])


def plan(defends: bool) -> pb.PlayerAction:
    """Searches chains of passes and dribbles. Defenders pass rather than dribble."""
    return pb.PlayerAction(helios_offensive_planner=pb.HeliosOffensivePlanner(
        direct_pass=True, lead_pass=True, through_pass=True, short_dribble=True,
        long_dribble=not defends, cross=not defends, simple_pass=True, simple_dribble=True,
        simple_shoot=True, evaluation=evaluation(defends)))


def evaluation(defends: bool) -> pb.PlannerEvaluation:
    """Factors by the first action of a chain, and costs of opponents at 0, 1, 2, ... meters."""
    factors = pb.ActionTypeEffector(
        direct_pass=1.2 if defends else 1.0, lead_pass=1.0, through_pass=1.1,
        short_dribble=0.8 if defends else 1.0, long_dribble=1.0, cross=1.0, hold=1.0)
    near = pb.OpponentEffector(negetive_effect_by_distance=[-8.0, -5.0, -2.0])
    return pb.PlannerEvaluation(effectors=pb.PlannerEvaluationEffector(
        action_type_effector=factors, opponent_effector=near))


def decide_as_coach(state: pb.State) -> pb.CoachActions:
    return pb.CoachActions(actions=[actions.substitute(), actions.say_player_types()])


def decide_as_trainer(state: pb.State) -> pb.TrainerActions:
    return pb.TrainerActions()
