"""Constructors of the actions that the team uses. docs/actions.md describes all actions."""
from __future__ import annotations

from cls_playmaker import proto as pb

from situation import Point


def _vector(place: Point) -> pb.RpcVector2D:
    return pb.RpcVector2D(x=place.x + 0.0, y=place.y + 0.0)  # + 0.0: never a negative zero


def before_kick_off(place: Point) -> pb.PlayerAction:
    return pb.PlayerAction(bhv_before_kick_off=pb.Bhv_BeforeKickOff(point=_vector(place)))


def smart_kick(target: Point, speed: float, min_speed: float, kicks: int) -> pb.PlayerAction:
    return pb.PlayerAction(body_smart_kick=pb.Body_SmartKick(
        target_point=_vector(target), first_speed=speed, first_speed_threshold=min_speed,
        max_steps=kicks))


def dribble(target: Point, dash_power: float, dashes: int) -> pb.PlayerAction:
    return pb.PlayerAction(body_dribble=pb.Body_Dribble(
        target_point=_vector(target), distance_threshold=1.0, dash_power=dash_power,
        dash_count=dashes, dodge=True))


def go_to(target: Point, within: float, dash_power: float) -> pb.PlayerAction:
    return pb.PlayerAction(body_go_to_point=pb.Body_GoToPoint(
        target_point=_vector(target), distance_threshold=within, max_dash_power=dash_power))


def intercept(face: Point) -> pb.PlayerAction:
    return pb.PlayerAction(body_intercept=pb.Body_Intercept(face_point=_vector(face)))


def hold_ball(face: Point) -> pb.PlayerAction:
    return pb.PlayerAction(body_hold_ball=pb.Body_HoldBall(
        do_turn=True, turn_target_point=_vector(face), kick_target_point=_vector(face)))


def clear_ball() -> pb.PlayerAction:
    return pb.PlayerAction(body_clear_ball=pb.Body_ClearBall())


def turn_to_ball() -> pb.PlayerAction:
    return pb.PlayerAction(body_turn_to_ball=pb.Body_TurnToBall(cycle=1))


def watch_ball(max_age: int) -> pb.PlayerAction:
    """The neck: to the ball if its estimate is older than max_age cycles, else around."""
    return pb.PlayerAction(
        neck_turn_to_ball_or_scan=pb.Neck_TurnToBallOrScan(count_threshold=max_age))


def watch_goalie() -> pb.PlayerAction:
    return pb.PlayerAction(neck_turn_to_goalie_or_scan=pb.Neck_TurnToGoalieOrScan())


def shoot() -> pb.PlayerAction:
    return pb.PlayerAction(helios_shoot=pb.HeliosShoot())


def basic_move() -> pb.PlayerAction:
    """Without the ball: tackle, block, mark, or move to the proxy's own formation."""
    return pb.PlayerAction(helios_basic_move=pb.HeliosBasicMove())


def goalie() -> pb.PlayerAction:
    return pb.PlayerAction(helios_goalie=pb.HeliosGoalie())


def set_play() -> pb.PlayerAction:
    return pb.PlayerAction(helios_set_play=pb.HeliosSetPlay())


def penalty() -> pb.PlayerAction:
    return pb.PlayerAction(helios_penalty=pb.HeliosPenalty())


def substitute() -> pb.CoachAction:
    return pb.CoachAction(do_helios_substitute=pb.DoHeliosSubstitute())


def say_player_types() -> pb.CoachAction:
    return pb.CoachAction(do_helios_say_player_types=pb.DoHeliosSayPlayerTypes())


def show_text(text: str) -> pb.PlayerAction:
    """In the page of the match, tab Drawings; moves nothing."""
    return pb.PlayerAction(log=pb.Log(add_text=pb.AddText(level=pb.TEAM, message=text)))


def show_line(start: Point, end: Point, color: str) -> pb.PlayerAction:
    """On the field in the page of the match; moves nothing."""
    return pb.PlayerAction(log=pb.Log(add_line=pb.AddLine(
        level=pb.TEAM, start=_vector(start), end=_vector(end), color=color)))


def plan_attack() -> pb.PlayerAction:
    """With the ball: the best of the passes and dribbles that the proxy finds."""
    return pb.PlayerAction(helios_offensive_planner=pb.HeliosOffensivePlanner(
        direct_pass=True, lead_pass=True, through_pass=True, short_dribble=True,
        long_dribble=True, cross=True, simple_pass=True, simple_dribble=True))
