"""A policy as a Playmaker: python3 -m cls_gym.play POLICY --port PORT

    cls match "run:python3 -m cls_gym.play policy.npz --port {port}" mock

The policy decides in play_on for the field player who reaches the ball first. Goalie, set plays,
penalties and the other players use the skills of cls. It sees what the player knows: the world
model of the State, never the full state, whatever it was trained with. It needs cls_playmaker
(pip install ./python).
"""
from __future__ import annotations

import argparse
import sys
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from cls_gym.policy import Policy, PolicyError, load

FEATURES, FEATURE_VERSION = "ego", 1
ACTIONS, ACTION_VERSION = "low_discrete", 1
_MAX_AGE = 10  # cycles after which an object counts as not seen
_FAR, _BALL_SPEED, _PLAYER_SPEED = 60.0, 3.0, 1.2
_GOAL, _POST = 52.5, 7.01
_PLAYER_FEATURES = 10


class _Axes(NamedTuple):
    """The player's: `forward` is a unit vector along the body."""

    origin: Tuple[float, float]
    forward: Tuple[float, float]


def _clip(value: float, low: float, high: float) -> float:
    return min(max(value, low), high)


def _vector(axes: _Axes, x: float, y: float, scale: float) -> List[float]:
    fx, fy = axes.forward
    return [_clip((fx * x + fy * y) / scale, -1.0, 1.0),
            _clip((fx * y - fy * x) / scale, -1.0, 1.0)]


def _point(axes: _Axes, x: float, y: float) -> List[float]:
    """Sine and cosine of the direction, and the distance."""
    dx, dy = x - axes.origin[0], y - axes.origin[1]
    length = float(np.hypot(dx, dy))
    if length == 0.0:
        return [0.0, 1.0, 0.0]
    cos, sin = _vector(axes, dx / length, dy / length, 1.0)
    return [sin, cos, _clip(length / _FAR, 0.0, 1.0)]


def _flag(on: bool) -> float:
    return 1.0 if on else -1.0


def ego_features(world: Any, teammates: int, opponents: int) -> np.ndarray:
    """float32[F]: the feature set "ego" from a protos.WorldModel, with the nearest players of both
    teams. Velocities and bodies that the player does not know are zeros."""
    me = world.self
    body = np.radians(me.body_direction)
    axes = _Axes((me.position.x, me.position.y), (float(np.cos(body)), float(np.sin(body))))
    play_on = world.DESCRIPTOR.fields_by_name["game_mode_type"].enum_type.values_by_name["PlayOn"]
    values = [_clip(me.position.x / 52.5, -1.2, 1.2), _clip(me.position.y / 34.0, -1.2, 1.2),
              axes.forward[1], axes.forward[0],
              *_vector(axes, me.velocity.x, me.velocity.y, _PLAYER_SPEED),
              _clip(me.stamina / 8000.0, 0.0, 1.0), _flag(me.is_kickable), _flag(me.is_tackling),
              _flag(world.game_mode_type == play_on.number), 1.0]
    values += _ball(axes, world.ball)
    for x, y in ((_GOAL, 0.0), (_GOAL, -_POST), (_GOAL, _POST), (-_GOAL, 0.0)):
        values += _point(axes, x, y)
    for players, count in ((world.teammates, teammates), (world.opponents, opponents)):
        values += _players(axes, world.ball, players, count)
    return np.array(values, np.float32)


def _ball(axes: _Axes, ball: Any) -> List[float]:
    if ball.pos_count > _MAX_AGE:
        return [-1.0] + [0.0] * 7
    speed = (ball.velocity.x, ball.velocity.y) if ball.vel_count <= _MAX_AGE else (0.0, 0.0)
    return [1.0, *_point(axes, ball.position.x, ball.position.y),
            *_vector(axes, *speed, _BALL_SPEED), _clip(ball.position.x / 52.5, -1.2, 1.2),
            _clip(ball.position.y / 34.0, -1.2, 1.2)]


def _players(axes: _Axes, ball: Any, players: Sequence[Any], count: int) -> List[float]:
    seen = sorted((one for one in players if one.pos_count <= _MAX_AGE),
                  key=lambda one: one.dist_from_self)[:count]
    values: List[float] = []
    for one in seen:
        speed = (one.velocity.x, one.velocity.y) if one.vel_count <= _MAX_AGE else (0.0, 0.0)
        facing = [0.0, 0.0]
        if one.body_direction_count <= _MAX_AGE:
            angle = np.radians(one.body_direction)
            facing = _vector(axes, float(np.cos(angle)), float(np.sin(angle)), 1.0)
        to_ball = float(np.hypot(one.position.x - ball.position.x,
                                 one.position.y - ball.position.y))
        values += [1.0, *_point(axes, one.position.x, one.position.y),
                   *_vector(axes, *speed, _PLAYER_SPEED), *facing, _flag(one.is_goalie),
                   _clip(to_ball / _FAR, 0.0, 1.0)]
    for _ in range(count - len(seen)):
        values += [-1.0] + [0.0] * (_PLAYER_FEATURES - 1)
    return values


def commands(names: Sequence[str], pb: Any) -> List[Optional[Any]]:
    """The protos.PlayerAction of each id of "low_discrete"; None of noop."""
    found: List[Optional[Any]] = []
    for name in names:
        kind, *numbers = name.split("_")
        if kind == "noop":
            found.append(None)
        elif kind == "dash":
            found.append(pb.PlayerAction(dash=pb.Dash(power=float(numbers[0]),
                                                      relative_direction=float(numbers[1]))))
        elif kind == "turn":
            found.append(pb.PlayerAction(turn=pb.Turn(relative_direction=float(numbers[0]))))
        elif kind == "kick":
            direction = 22.5 * int(numbers[1]) - 180.0
            found.append(pb.PlayerAction(kick=pb.Kick(power=float(numbers[0]),
                                                      relative_direction=direction)))
        else:
            found.append(pb.PlayerAction(tackle=pb.Tackle(power_or_dir=float(numbers[0]))))
    return found


def check(policy: Policy, path: str) -> None:
    """Raises PolicyError for a policy that no State can serve."""
    about = policy.about
    for kind, name, version in (("features", FEATURES, FEATURE_VERSION),
                                ("actions", ACTIONS, ACTION_VERSION)):
        has = about.get(kind), about.get(kind[:-1] + "_version")
        if has != (name, version):
            raise PolicyError(f"{path}: {kind} {has[0]!r} version {has[1]}; a Playmaker has "
                              f"{name!r} version {version}: train with {kind}={name!r}")


class Decider:
    """Decisions of a policy on States."""

    def __init__(self, policy: Policy, pb: Any) -> None:
        self._policy = policy
        self._pb = pb
        names = policy.about["action_names"]
        self._commands = commands(names, pb)
        self._needs_ball = np.array([name.startswith("kick") for name in names])
        self._tackles = np.array([name.startswith("tackle") for name in names])

    def choose(self, world: Any) -> int:
        """The id of the action for a protos.WorldModel."""
        about: Dict[str, Any] = self._policy.about
        seen = ego_features(world, about["teammates"], about["opponents"])
        mask = np.ones(len(self._commands), np.int8)
        mask[self._needs_ball] = world.self.is_kickable
        mask[self._tackles] = world.self.tackle_probability > 0.0
        return int(self._policy.act(seen, mask))

    def decide(self, state: Any) -> Any:
        """protos.PlayerActions for a protos.State."""
        pb, world = self._pb, state.world_model
        if world.is_penalty_kick_mode:
            return self._skills(pb.PlayerAction(helios_penalty=pb.HeliosPenalty()))
        if world.game_mode_type != pb.PlayOn:
            return self._skills(pb.PlayerAction(helios_set_play=pb.HeliosSetPlay()))
        if world.self.is_goalie:
            return self._skills(pb.PlayerAction(helios_goalie=pb.HeliosGoalie()))
        others = [one.ball_reach_steps for one in world.teammates if not one.is_goalie]
        if not world.self.is_kickable and world.self.ball_reach_steps > min(others, default=1000):
            return self._skills(pb.PlayerAction(helios_basic_move=pb.HeliosBasicMove()))
        command = self._commands[self.choose(world)]
        look = pb.PlayerAction(neck_turn_to_ball_or_scan=pb.Neck_TurnToBallOrScan())
        return pb.PlayerActions(ignore_preprocess=True, ignore_doforcekick=True,
                                ignore_doHeardPassRecieve=True, ignore_doIntention=True,
                                ignore_shootInPreprocess=True,
                                actions=[command, look] if command else [look])

    def _skills(self, body: Any) -> Any:
        look = self._pb.PlayerAction(neck_turn_to_ball_or_scan=self._pb.Neck_TurnToBallOrScan())
        return self._pb.PlayerActions(actions=[body, look])


def main() -> int:
    parser = argparse.ArgumentParser(prog="python3 -m cls_gym.play",
                                     description="Serves a trained policy as a Playmaker.")
    parser.add_argument("policy", metavar="POLICY", help="file of cls_gym.policy (.npz)")
    parser.add_argument("--port", type=int, default=50051,
                        help="listening port; 0 selects a free one (default: 50051)")
    options = parser.parse_args()
    try:
        policy = load(options.policy)
        check(policy, options.policy)
    except PolicyError as error:
        sys.exit(f"cls_gym.play: {error}")
    try:
        from cls_playmaker import Playmaker, proto, serve
    except ImportError as error:
        sys.exit(f"cls_gym.play: {error}; install the package: pip install ./python")

    class Team(Playmaker):
        """The policy for every player."""

        def __init__(self) -> None:
            self._decider = Decider(policy, proto)

        def GetPlayerActions(self, request: Any, context: Any) -> Any:
            return self._decider.decide(request)

    serve(Team(), options.port)
    return 0


if __name__ == "__main__":
    sys.exit(main())
