"""A policy as a Playmaker: python3 -m cls_gym.play POLICY --port PORT

    cls match "run:python3 -m cls_gym.play policy.npz --port {port}" mock

The match sends the numbers that the policy observes, computed by the engine that trained it, from
what each player knows: its world model, never the full state (docs/wire.md, TENSOR). In play_on the
policy decides for the field player who is nearest to the ball, or with --who all for each of them.
Goalie, set plays, penalties and the other players use the skills of cls. A rated match refuses a
policy that was trained with the full state. It needs cls_playmaker (pip install ./python).
"""
from __future__ import annotations

import argparse
import sys
from typing import Any, Dict, List

import numpy as np

from cls_gym.policy import Policy, PolicyError, load

GOALIE = 1  # uniform number: cls teams connect their goalie first
_BALL = ("ball_seen", "ball_distance")


def check(policy: Policy, path: str, who: str) -> None:
    """Raises PolicyError for a policy that cannot play."""
    about = policy.about
    missing = [key for key in ("features", "feature_version", "actions", "action_version",
                               "teammates", "opponents", "obs") if key not in about]
    if missing:
        raise PolicyError(f"{path}: about lacks {', '.join(missing)}: save it with "
                          "cls_gym.policy.describe()")
    if who == "nearest" and not set(_BALL) <= set(about["feature_names"]):
        raise PolicyError(f"{path}: features {about['features']!r} do not say who is nearest to "
                          "the ball: use --who all")


def skill(pb: Any, unum: int, play_mode: str) -> Any:
    """What a player does without the policy: proto.PlayerActions of the module `pb`."""
    if play_mode.startswith("penalty_"):
        body = pb.PlayerAction(helios_penalty=pb.HeliosPenalty())
    elif play_mode != "play_on":
        body = pb.PlayerAction(helios_set_play=pb.HeliosSetPlay())
    elif unum == GOALIE:
        body = pb.PlayerAction(helios_goalie=pb.HeliosGoalie())
    else:
        body = pb.PlayerAction(helios_basic_move=pb.HeliosBasicMove())
    look = pb.PlayerAction(neck_turn_to_ball_or_scan=pb.Neck_TurnToBallOrScan())
    return pb.PlayerActions(actions=[body, look])


class Decider:
    """Decisions of a policy for the players of a team."""

    def __init__(self, policy: Policy, pb: Any, who: str) -> None:
        self._policy = policy
        self._pb = pb
        self._who = who
        names: List[str] = policy.about["feature_names"]
        self._features, self._ids = len(names), len(policy.about["action_names"])
        self._ball = [names.index(name) for name in _BALL if name in names]

    def decide(self, rows: Any, actions_type: Any) -> Any:
        """cls_playmaker.TeamActions for TeamRows."""
        count = len(rows.players)
        features = np.frombuffer(rows.features, "<f4").reshape(count, self._features)
        masks = np.frombuffer(rows.masks, np.uint8).reshape(count, self._ids)
        acts = self.acting(rows.players, rows.play_mode, features)
        replies = {unum: skill(self._pb, unum, rows.play_mode)
                   for unum, own in zip(rows.players, acts) if not own}
        ids = self._policy.act(features, masks).astype("<f4").reshape(count, 1)
        return actions_type(ids.tobytes() if acts.any() else b"", 1, replies)

    def acting(self, players: List[int], play_mode: str, features: np.ndarray) -> np.ndarray:
        """bool[players]: for whom the policy decides."""
        acts = np.array([play_mode == "play_on" and unum != GOALIE for unum in players])
        if self._who == "all" or not acts.any():
            return acts
        seen, distance = (features[:, column] for column in self._ball)
        away = np.where(acts & (seen > 0), distance, np.inf)
        nearest = np.zeros_like(acts)
        nearest[away.argmin()] = np.isfinite(away.min())
        return nearest


def refusal(about: Dict[str, Any], path: str, rated: bool) -> str:
    """Why the policy plays no such match; empty: it does."""
    if rated and about["obs"] != "world_model":
        return (f"{path} was trained with obs={about['obs']!r}, which no player knows; rated "
                "matches are for obs='world_model'; train it so (--obs world_model of the "
                "examples), or play it with cls match")
    return ""


def main() -> int:
    parser = argparse.ArgumentParser(prog="python3 -m cls_gym.play",
                                     description="Serves a trained policy as a Playmaker.")
    parser.add_argument("policy", metavar="POLICY", help="file of cls_gym.policy (.npz)")
    parser.add_argument("--port", type=int, default=50051,
                        help="listening port; 0 selects a free one (default: 50051)")
    parser.add_argument("--who", choices=("nearest", "all"), default="nearest",
                        help="the field players for whom the policy decides in play_on: the one "
                             "nearest to the ball, or all (default: nearest)")
    options = parser.parse_args()
    try:
        policy = load(options.policy)
        check(policy, options.policy, options.who)
    except PolicyError as error:
        sys.exit(f"cls_gym.play: {error}")
    try:
        from cls_playmaker import Playmaker, RowForm, TeamActions, proto, serve
    except ImportError as error:
        sys.exit(f"cls_gym.play: {error}; install the package: pip install ./python")
    about = policy.about

    class Team(Playmaker):  # type: ignore[misc,unused-ignore]
        """The policy for every player."""

        row_form = RowForm(f"{about['features']}/{about['feature_version']}",
                           f"{about['actions']}/{about['action_version']}",
                           about["teammates"], about["opponents"])

        def __init__(self) -> None:
            self._decider = Decider(policy, proto, options.who)

        def refuses(self, rated: bool) -> str:
            return refusal(about, options.policy, rated)

        def GetTeamRows(self, rows: Any) -> Any:
            return self._decider.decide(rows, TeamActions)

    serve(Team(), options.port)
    return 0


if __name__ == "__main__":
    sys.exit(main())
