#!/usr/bin/env python3
"""A complete Playmaker: simple soccer on the package cls_playmaker (docs/playmaker.md).

    python3 examples/python/playmaker.py --port 50051
    cls match mock localhost:50051
"""
import math
import os
import sys

# A copy elsewhere needs the installed package: pip install ./python
sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../build/python"))
from cls_playmaker import Playmaker, proto as pb, serve  # noqa: E402

HOME = {1: (-50, 0), 2: (-20, -6), 3: (-20, 6), 4: (-16, -18), 5: (-16, 18), 6: (-8, 0),
        7: (0, -10), 8: (0, 10), 9: (10, -20), 10: (10, 20), 11: (12, 0)}


def point(x, y):
    return pb.RpcVector2D(x=x, y=y)


def distance(a, b):
    return math.hypot(a.x - b.x, a.y - b.y)


def kick(target, speed):
    return pb.PlayerAction(body_smart_kick=pb.Body_SmartKick(
        target_point=target, first_speed=speed, first_speed_threshold=0.1, max_steps=2))


def home(world):
    """The own home position: follows the ball and stays onside."""
    (x, y), ball = HOME[world.self.uniform_number], world.ball.position
    if world.self.is_goalie:
        return point(x, max(-6, min(6, ball.y * 0.2)))
    return point(min(x + 0.6 * ball.x, max(world.offside_line_x - 1, 0), 45), y + 0.3 * ball.y)


def with_ball(world):
    """Shoot near the goal, pass to the most advanced free teammate, or dribble to the goal."""
    ball, goal = world.ball.position, point(52.5, 0)
    if distance(ball, goal) < 22:
        keeper = next((p.position.y for p in world.opponents if p.is_goalie), 0.0)
        return kick(point(52.5, -5.5 if keeper > 0 else 5.5), 3.0)
    free = [mate.position for mate in world.teammates if mate.pos_count < 5
            and ball.x < mate.position.x < world.offside_line_x
            and all(distance(mate.position, other.position) > 4 for other in world.opponents)]
    if free and world.intercept_table.first_opponent_reach_steps < 6:
        target = max(free, key=lambda place: place.x)
        return kick(target, min(1.0 + 0.06 * distance(ball, target), 2.7))
    return pb.PlayerAction(body_dribble=pb.Body_Dribble(
        target_point=point(48, 0.7 * ball.y), distance_threshold=1, dash_power=90, dash_count=3))


def decide(world):
    """The actions of one player for one cycle; the first possible body action is executed."""
    table, me = world.intercept_table, world.self
    mate = table.first_teammate_reach_steps if table.first_teammate_id else 1000
    if world.game_mode_type in (pb.BeforeKickOff, pb.AfterGoal_):
        x, y = HOME[me.uniform_number]
        yield pb.PlayerAction(bhv_before_kick_off=pb.Bhv_BeforeKickOff(point=point(min(x, -1), y)))
    elif world.is_our_set_play:  # the kicker may not touch the ball twice
        yield pb.PlayerAction(helios_set_play=pb.HeliosSetPlay())
    elif me.is_goalie and me.catch_probability > 0.8:
        yield pb.PlayerAction(catch=pb.Catch())
    elif me.is_kickable and not world.is_their_set_play:
        yield with_ball(world)
    elif table.self_reach_steps <= mate and not world.kickable_teammate_existance:
        yield pb.PlayerAction(body_intercept=pb.Body_Intercept(face_point=point(52.5, 0)))
    yield pb.PlayerAction(body_go_to_point=pb.Body_GoToPoint(
        target_point=home(world), distance_threshold=1, max_dash_power=80))
    yield pb.PlayerAction(body_turn_to_ball=pb.Body_TurnToBall(cycle=1))
    yield pb.PlayerAction(neck_turn_to_ball_or_scan=pb.Neck_TurnToBallOrScan())


class Team(Playmaker):
    def GetPlayerActions(self, state, context):
        return pb.PlayerActions(actions=decide(state.world_model), ignore_preprocess=True)


if __name__ == "__main__":
    serve(Team())
