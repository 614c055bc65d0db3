"""The team's decisions: the place for your own ideas. examples/TEAM.md describes the team."""
from __future__ import annotations

from typing import List, NamedTuple, Optional

import actions
from cls_playmaker import proto as pb
from situation import GOAL, Point, Situation, clamp, distance, point


class Home(NamedTuple):
    """A position with the ball at the center mark, and how much of the ball's way it follows."""
    x: float
    y: float
    follow_x: float
    follow_y: float
    min_x: float
    max_x: float
    kick_off: Point


FORMATION = (  # 4-3-3 by uniform number; 1 is the goalie
    Home(-50.0, 0.0, 0.0, 0.0, -50.0, -50.0, Point(-50.0, 0.0)),
    Home(-20.0, -7.0, 0.60, 0.25, -45.0, 14.0, Point(-20.0, -7.0)),
    Home(-20.0, 7.0, 0.60, 0.25, -45.0, 14.0, Point(-20.0, 7.0)),
    Home(-17.0, -20.0, 0.65, 0.25, -43.0, 28.0, Point(-18.0, -20.0)),
    Home(-17.0, 20.0, 0.65, 0.25, -43.0, 28.0, Point(-18.0, 20.0)),
    Home(-7.0, 0.0, 0.70, 0.45, -38.0, 32.0, Point(-11.0, 0.0)),
    Home(1.0, -12.0, 0.75, 0.35, -34.0, 40.0, Point(-8.0, -11.0)),
    Home(1.0, 12.0, 0.75, 0.35, -34.0, 40.0, Point(-8.0, 11.0)),
    Home(15.0, -25.0, 0.75, 0.15, -24.0, 47.0, Point(-1.5, -22.0)),
    Home(15.0, 25.0, 0.75, 0.15, -24.0, 47.0, Point(-1.5, 22.0)),
    Home(18.0, 0.0, 0.75, 0.30, -16.0, 47.0, Point(-0.8, 0.0)),
)
DRIBBLE_DIRECTIONS = (  # 0, 37, -37, 53 and -53 degrees: exact sides of a right triangle
    Point(1.0, 0.0), Point(0.8, 0.6), Point(0.8, -0.6), Point(0.6, 0.8), Point(0.6, -0.8))


class Pass(NamedTuple):
    target: Point
    speed: float
    value: float


def decide(state: pb.State) -> pb.PlayerActions:
    """The actions of one player for one cycle; the first possible body action is executed."""
    now = Situation(state)
    world = now.world
    if world.is_penalty_kick_mode:
        return pb.PlayerActions(actions=[actions.penalty()])
    if world.game_mode_type in (pb.BeforeKickOff, pb.AfterGoal_):
        home = FORMATION[world.self.uniform_number - 1]
        return pb.PlayerActions(ignore_preprocess=True, actions=[
            actions.before_kick_off(home.kick_off), actions.watch_ball(0)])
    if world.game_mode_type != pb.PlayOn:
        return pb.PlayerActions(actions=[actions.set_play()])
    if world.self.is_goalie:
        return pb.PlayerActions(actions=[actions.goalie()])
    if world.self.is_kickable:
        return pb.PlayerActions(actions=with_ball(now))
    return pb.PlayerActions(actions=without_ball(now))


def decide_as_coach(state: pb.State) -> pb.CoachActions:
    """Substitutions, and the opponents' player types for the players."""
    return pb.CoachActions(actions=[actions.substitute(), actions.say_player_types()])


def decide_as_trainer(state: pb.State) -> pb.TrainerActions:
    """A trainer may move ball and players: a place for exercises. This one watches."""
    return pb.TrainerActions()


def with_ball(now: Situation) -> List[pb.PlayerAction]:
    chosen = [actions.shoot()]
    corner = shot(now)
    if corner is not None:
        chosen.append(actions.smart_kick(corner, 3.0, 2.0, 2))
    pressed = now.room(now.ball) < 3.0
    best = best_pass(now)
    if best is not None and (pressed or best.value > value(now, now.ball) + 2.0):
        chosen.append(actions.smart_kick(best.target, best.speed, best.speed * 0.8, 3))
    if pressed and now.ball.x < -20.0:
        chosen.append(actions.clear_ball())
    chosen.append(actions.dribble(dribble_target(now), 90.0, 2 if pressed else 4))
    chosen.append(actions.hold_ball(GOAL))
    chosen.append(actions.watch_goalie() if corner is not None else actions.watch_ball(0))
    return chosen


def shot(now: Situation) -> Optional[Point]:
    """The place between the posts that opponents are farthest from."""
    if distance(now.ball, GOAL) > 20.0:
        return None
    best = None
    widest = 0.0
    for y in (-6.0, -3.0, 0.0, 3.0, 6.0):
        target = Point(GOAL.x, y)
        margin = now.lane(now.ball, target)
        if margin > widest:
            best = target
            widest = margin
    return best


def value(now: Situation, place: Point) -> float:
    """Of the ball at a place: forward, near the goal, away from opponents."""
    return place.x - 0.2 * distance(place, GOAL) + 0.6 * min(now.room(place), 8.0)


def best_pass(now: Situation) -> Optional[Pass]:
    best = None
    for mate in now.world.teammates:
        if mate.pos_count > 8 or mate.is_goalie or mate.is_tackling:
            continue
        place = point(mate.position)
        if place.x > 0.0 and place.x > now.world.offside_line_x - 0.3 and place.x > now.ball.x:
            continue  # offside
        ahead = 3.0 if place.x < 36.0 else 0.0
        target = Point(clamp(place.x + 2.0 * mate.velocity.x + ahead, -50.0, 50.0),
                       clamp(place.y + 2.0 * mate.velocity.y, -32.0, 32.0))
        length = distance(now.ball, target)
        if length < 5.0 or length > 32.0 or (target.x < -25.0 and target.x < now.ball.x):
            continue  # too short, too long, or toward the own goal
        if now.lane(now.ball, target) < 0.0:
            continue
        found = Pass(target, min(1.2 + 0.06 * length, 2.7), value(now, target))
        if best is None or found.value > best.value:
            best = found
    return best


def dribble_target(now: Situation) -> Point:
    """8 m ahead toward the goal, past the opponents in the way."""
    away = distance(now.me, GOAL)
    if away < 0.1:
        return GOAL
    dx = (GOAL.x - now.me.x) / away
    dy = (GOAL.y - now.me.y) / away
    best = GOAL
    best_room = -1000.0
    for index, turn in enumerate(DRIBBLE_DIRECTIONS):
        target = Point(now.me.x + 8.0 * (dx * turn.x - dy * turn.y),
                       now.me.y + 8.0 * (dx * turn.y + dy * turn.x))
        if target.y < -32.0 or target.y > 32.0 or target.x > 51.0:
            continue
        room = min(now.lane(now.me, target), 4.0) - 0.5 * index
        if room > best_room:
            best = target
            best_room = room
    return best


def without_ball(now: Situation) -> List[pb.PlayerAction]:
    first = now.my_steps <= now.our_steps
    if first and now.my_steps <= now.their_steps + 1:
        return [actions.intercept(GOAL), actions.turn_to_ball(), actions.watch_ball(0)]
    if now.their_steps <= now.our_steps or first:
        return [actions.basic_move(), actions.watch_ball(1)]
    home = home_position(now)
    return [actions.go_to(home, 0.8, dash_power(now, home)), actions.turn_to_ball(),
            actions.watch_ball(2)]


def home_position(now: Situation) -> Point:
    """The formation moves with the ball; forwards wait on the offside line."""
    home = FORMATION[now.world.self.uniform_number - 1]
    line = now.world.offside_line_x - 0.5
    x = clamp(home.x + home.follow_x * now.ball.x, home.min_x, home.max_x)
    if now.world.self.uniform_number >= 9:
        x = max(x, min(min(line, now.ball.x + 22.0), 46.0))
    x = min(x, max(line, 0.0))
    return Point(x, clamp(home.y + home.follow_y * now.ball.y, -32.0, 32.0))


def dash_power(now: Situation, target: Point) -> float:
    """Stamina must last for a half."""
    if now.world.self.stamina < 3500.0:
        return 35.0
    if now.me.x > target.x + 3.0 or distance(now.ball, target) < 15.0:
        return 100.0
    return 65.0
