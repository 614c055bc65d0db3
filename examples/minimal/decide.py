"""The team's decisions: the place for your own ideas."""
from __future__ import annotations

import actions
from cls_playmaker import proto as pb
from situation import GOAL, point


def decide(state: pb.State) -> pb.PlayerActions:
    """The actions of one player for one cycle; the first possible body action is executed."""
    world = state.world_model
    if world.game_mode_type != pb.PlayOn:
        return pb.PlayerActions(actions=[actions.set_play()])
    if world.self.is_goalie:
        return pb.PlayerActions(actions=[actions.goalie()])
    if world.self.is_kickable:
        return pb.PlayerActions(actions=[
            actions.show_line(point(world.ball.position), GOAL, "yellow"),
            actions.show_text("has the ball"),
            actions.smart_kick(GOAL, 3.0, 0.1, 3), actions.watch_ball(0)])
    return pb.PlayerActions(actions=[actions.basic_move()])


def decide_as_coach(state: pb.State) -> pb.CoachActions:
    return pb.CoachActions(actions=[actions.substitute()])


def decide_as_trainer(state: pb.State) -> pb.TrainerActions:
    return pb.TrainerActions()
