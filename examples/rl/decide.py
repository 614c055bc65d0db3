"""The team's decisions: a policy chooses what to do with the ball, the proxy does the rest."""
from __future__ import annotations

import os
from typing import Dict, List

import actions
from cls_playmaker import proto as pb
from situation import GOAL, Point, Situation, distance

POLICY = os.environ.get("POLICY") or os.path.join(os.path.dirname(__file__), "policy.txt")


def read_policy(path: str) -> Dict[str, List[float]]:
    """The weights of each action."""
    with open(path, encoding="utf-8") as file:
        rows = [line.split() for line in file if line.strip() and not line.startswith("#")]
    return {row[0]: [float(weight) for weight in row[1:]] for row in rows}


WEIGHTS = read_policy(POLICY)


def features(now: Situation) -> List[float]:
    """What the policy sees, each about 0 to 1: bias, goal, room, lane, own_half."""
    ahead = Point(now.me.x + 8.0, now.me.y)
    return [1.0, max(0.0, 1.0 - distance(now.ball, GOAL) / 50.0), min(now.room(now.ball), 10.0) / 10.0,
            min(max(now.lane(now.me, ahead), 0.0), 4.0) / 4.0, 1.0 if now.ball.x < 0.0 else 0.0]


def action(name: str) -> pb.PlayerAction:
    if name == "shoot":
        return actions.smart_kick(GOAL, 3.0, 2.0, 2)
    if name == "pass":
        return pb.PlayerAction(helios_offensive_planner=pb.HeliosOffensivePlanner(
            direct_pass=True, lead_pass=True, through_pass=True, max_depth=1))
    if name == "dribble":
        return actions.dribble(GOAL, 90.0, 4)
    if name == "clear":
        return actions.clear_ball()
    return actions.hold_ball(GOAL)


def with_ball(now: Situation) -> List[pb.PlayerAction]:
    """All actions, the one with the highest score first: the first possible one is executed."""
    seen = features(now)
    scores = {name: sum(w * x for w, x in zip(weights, seen)) for name, weights in WEIGHTS.items()}
    ranked = sorted(scores, key=lambda name: -scores[name])
    return [action(name) for name in ranked] + [actions.watch_ball(0)]


def decide(state: pb.State) -> pb.PlayerActions:
    """The actions of one player for one cycle."""
    now = Situation(state)
    world = now.world
    if world.is_penalty_kick_mode:
        return pb.PlayerActions(actions=[actions.penalty()])
    if world.game_mode_type != pb.PlayOn:
        return pb.PlayerActions(actions=[actions.set_play()])
    if world.self.is_goalie:
        return pb.PlayerActions(actions=[actions.goalie()])
    if world.self.is_kickable:
        return pb.PlayerActions(actions=with_ball(now))
    return pb.PlayerActions(actions=[actions.basic_move(), actions.watch_ball(1)])


def decide_as_coach(state: pb.State) -> pb.CoachActions:
    return pb.CoachActions(actions=[actions.substitute(), actions.say_player_types()])


def decide_as_trainer(state: pb.State) -> pb.TrainerActions:
    return pb.TrainerActions()
