"""What a player knows in one cycle: geometry and facts derived from a State.

Only + - * / and sqrt, in a fixed order: every language computes the same bits.
"""
from __future__ import annotations

import functools
import math
from typing import Any, List, NamedTuple

from cls_playmaker import proto as pb

FAR = 1000.0  # meters or cycles: no player is there
MAX_AGE = 20  # cycles; older estimates of players are ignored


class Point(NamedTuple):
    x: float
    y: float


GOAL = Point(52.5, 0.0)  # every team attacks toward +x


def point(vector: pb.RpcVector2D) -> Point:
    return Point(vector.x, vector.y)


def distance(a: Point, b: Point) -> float:
    dx = a.x - b.x
    dy = a.y - b.y
    return math.sqrt(dx * dx + dy * dy)


def clamp(value: float, low: float, high: float) -> float:
    return low if value < low else high if value > high else value


class Situation:
    """The State of one player, with the facts that most decisions begin with."""

    def __init__(self, state: pb.State) -> None:
        self.world: Any = state.world_model
        self.me = point(self.world.self.position)
        self.ball = point(self.world.ball.position)
        table = self.world.intercept_table
        self.my_steps = 0 if self.world.self.is_kickable else table.self_reach_steps
        self.our_steps = _steps(self.world.kickable_teammate_existance,
                                table.first_teammate_id, table.first_teammate_reach_steps)
        self.their_steps = _steps(self.world.kickable_opponent_existance,
                                  table.first_opponent_id, table.first_opponent_reach_steps)

    @functools.cached_property
    def opponents(self) -> List[Point]:
        """Where opponents are who were seen lately."""
        return [point(player.position) for player in self.world.opponents
                if player.pos_count <= MAX_AGE]

    def room(self, place: Point) -> float:
        """The distance of the nearest opponent."""
        nearest = FAR
        for opponent in self.opponents:
            away = distance(opponent, place)
            if away < nearest:
                nearest = away
        return nearest

    def lane(self, start: Point, end: Point) -> float:
        """How far opponents stay away from a ball that rolls from start to end; below 0: they
        reach it. An opponent reaches 0.8 m, and 0.2 m more for each meter that the ball rolls."""
        dx = end.x - start.x
        dy = end.y - start.y
        length = math.sqrt(dx * dx + dy * dy)
        if length < 0.1:
            return FAR
        free = FAR
        for opponent in self.opponents:
            along = ((opponent.x - start.x) * dx + (opponent.y - start.y) * dy) / length
            if along < 0.0:
                continue
            if along > length:
                along = length
            share = along / length
            passed = Point(start.x + dx * share, start.y + dy * share)
            margin = distance(opponent, passed) - 0.8 - 0.2 * along
            if margin < free:
                free = margin
        return free


def _steps(kickable: bool, player_id: int, steps: int) -> int:
    """Cycles to the ball; a player id of 0 means that no such player is known."""
    if kickable:
        return 0
    return steps if player_id != 0 else int(FAR)
