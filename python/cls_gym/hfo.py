"""The Python interface of HFO (Half Field Offense), in the process instead of over a server.

>>> from cls_gym.hfo import *
>>> hfo = HFOEnvironment(seed=1)
>>> hfo.connectToServer(HIGH_LEVEL_FEATURE_SET)
>>> for episode in range(2):
...     status = IN_GAME
...     while status == IN_GAME:
...         features = hfo.getState()
...         hfo.act(DASH, 20.0, 0.0)
...         status = hfo.step()
...     print(hfo.statusToString(status))
OutOfTime
OutOfTime

What bin/HFO takes as options, the environment variable CLS_HFO has, or the arguments of
HFOEnvironment: CLS_HFO="--defense-npcs 1 --fullstate --trials 100 --seed 1". One agent plays; the
others are NPCs of cls. Ports, addresses and folders have no effect, nor has say(): there is no
other agent that could hear it.
"""
from __future__ import annotations

import argparse
import os
from typing import Any, Dict, List, NamedTuple, Optional

import numpy as np

from cls_gym._worlds import Worlds
from cls_gym.seeding import episode_seed, generator

LOW_LEVEL_FEATURE_SET, HIGH_LEVEL_FEATURE_SET = range(2)
NUM_HFO_ACTIONS = 20
(DASH, TURN, TACKLE, KICK, KICK_TO, MOVE_TO, DRIBBLE_TO, INTERCEPT, MOVE, SHOOT, PASS, DRIBBLE,
 CATCH, NOOP, QUIT, REDUCE_ANGLE_TO_GOAL, MARK_PLAYER, DEFEND_GOAL, GO_TO_BALL,
 REORIENT) = range(NUM_HFO_ACTIONS)
NUM_GAME_STATUS_STATES = 6
(IN_GAME, GOAL, CAPTURED_BY_DEFENSE, OUT_OF_BOUNDS, OUT_OF_TIME,
 SERVER_DOWN) = range(NUM_GAME_STATUS_STATES)
RIGHT, NEUTRAL, LEFT = range(-1, 2)

_ACTION_NAMES = ("Dash", "Turn", "Tackle", "Kick", "KickTo", "MoveTo", "DribbleTo", "Intercept",
                 "Move", "Shoot", "Pass", "Dribble", "Catch", "No-op", "Quit",
                 "Reduce_Angle_To_Goal", "Mark_Player", "Defend_Goal", "Go_To_Ball", "Reorient")
_STATUS_NAMES = ("InGame", "Goal", "CapturedByDefense", "OutOfBounds", "OutOfTime", "ServerDown")


class Player(NamedTuple):
    """A player: LEFT, RIGHT or NEUTRAL (no player), and uniform number."""

    side: int
    unum: int


def _settings(words: List[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="CLS_HFO", add_help=False)
    parser.add_argument("--offense-npcs", type=int, default=0)
    parser.add_argument("--defense-npcs", type=int, default=0)
    parser.add_argument("--fullstate", action="store_true")
    parser.add_argument("--trials", type=int, default=-1)
    parser.add_argument("--frames-per-trial", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=None)
    return parser.parse_args(words)


class HFOEnvironment:
    """One agent of a half field. Keyword arguments override CLS_HFO: offense_npcs=1, ..."""

    def __init__(self, **settings: Any) -> None:
        self._settings = _settings(os.environ.get("CLS_HFO", "").split())
        for name, value in settings.items():
            if not hasattr(self._settings, name):
                known = ", ".join(vars(self._settings))
                raise TypeError(f"HFOEnvironment: unknown {name!r}; settings: {known}")
            setattr(self._settings, name, value)
        self._worlds: Optional[Worlds] = None
        self._last_holder = Player(NEUTRAL, -1)
        self._trials = 0

    def connectToServer(self, feature_set: int = LOW_LEVEL_FEATURE_SET, config_dir: str = "",
                        server_port: int = 6000, server_addr: str = "localhost",
                        team_name: str = "base_left", play_goalie: bool = False,
                        record_dir: str = "") -> None:
        """Starts the first episode. `team_name` "base_right" joins the defense.

        `config_dir`, `server_port`, `server_addr` and `record_dir` have no effect. The agent is the
        goalie of the defense if `play_goalie` is true, or if it has no NPCs.
        """
        offense = not team_name.endswith("right")
        mine, others = (self._settings.offense_npcs, self._settings.defense_npcs)
        if not offense:
            mine, others = others, mine
        config: Dict[str, Any] = {
            "features": "hfo_high" if feature_set == HIGH_LEVEL_FEATURE_SET else "hfo_low",
            "actions": "hfo", "agents": "offense" if offense else "defense", "num_agents": 1,
            "goalie_agent": bool(play_goalie),
            "obs": "full_state" if self._settings.fullstate else "world_model",
            "max_cycles": self._settings.frames_per_trial,
            "offense": mine + 1 if offense else others, "defense": others if offense else mine + 1}
        self._random = generator(self._settings.seed)
        self._worlds = Worlds("HalfFieldOffense" if offense else "HalfFieldDefense", 1, config)
        self._action: Any = None
        self._start()

    def _start(self) -> None:
        self._open().reset(None, np.array([episode_seed(self._random)], np.uint64), None)

    def _open(self) -> Worlds:
        if self._worlds is None:
            raise RuntimeError("HFOEnvironment: call connectToServer() first")
        return self._worlds

    def getStateSize(self) -> int:
        """The number of features."""
        return int(self._open().observations.shape[1])

    def getState(self, state_data: Optional[np.ndarray] = None) -> np.ndarray:
        """float32[F]: the features now; written into `state_data` if it is given."""
        features = self._open().observations[0]
        if state_data is None:
            return np.array(features)
        state_data[...] = features
        return state_data

    def act(self, action_type: int, *args: float) -> None:
        """The action of the next step(), with its parameters in the units of HFO."""
        wanted = self.numParams(action_type)
        if wanted < 0:
            raise ValueError(f"act: unknown action {action_type!r}; actions: 0 to "
                             f"{NUM_HFO_ACTIONS - 1}")
        assert wanted == len(args), (f"Incorrect number of params to act: Required {wanted}, "
                                     f"provided {len(args)}")
        self._action = (action_type, args)

    def numParams(self, action_type: int) -> int:
        """Parameters of an action; -1 for an unknown one."""
        parameters = self._open().spec.actions.parameters
        return len(parameters[action_type]) if 0 <= action_type < len(parameters) else -1

    def step(self) -> int:
        """Plays a cycle and returns the status. After the end of an episode the next one has
        begun, as on HFO's server; after the last trial, and after QUIT: SERVER_DOWN."""
        worlds = self._open()
        action_type, args = self._action or (NOOP, ())
        if action_type == QUIT or self._trials == self._settings.trials:
            return SERVER_DOWN
        parameters = worlds.spec.actions.parameters
        start = sum(len(own) for own in parameters[:action_type])
        worlds.pool.action_ids[0, 0] = action_type
        worlds.pool.action_values[0, 0, start:start + len(args)] = args
        worlds.step()
        status = int(worlds.pool.status[0])
        self._last_holder = self._holder()
        if status != IN_GAME:
            self._trials += 1
            self._start()
        return status

    def _holder(self) -> Player:
        """The player who can kick the ball, the nearest one of several; else the last one."""
        world = self._open().pool.view(0)
        reach = [(np.hypot(one.x - world.ball_x, one.y - world.ball_y), one.side, one.unum)
                 for one in world.players if one.on_pitch
                 and np.hypot(one.x - world.ball_x, one.y - world.ball_y) <= one.kickable_area]
        return Player(*min(reach)[1:]) if reach else self._last_holder

    def playerOnBall(self) -> Player:
        """The player who has the ball, or had it last; Player(NEUTRAL, -1) before."""
        return self._last_holder

    def say(self, message: str) -> None:
        """Has no effect: there is no other agent."""

    def hear(self) -> str:
        """Always empty: there is no other agent."""
        return ""

    def actionToString(self, action: int) -> str:
        """The name of an action."""
        return _ACTION_NAMES[action] if 0 <= action < NUM_HFO_ACTIONS else "Unknown"

    def statusToString(self, status: int) -> str:
        """The name of a status."""
        return _STATUS_NAMES[status] if 0 <= status < NUM_GAME_STATUS_STATES else "Unknown"

    def getUnum(self) -> int:
        """The agent's uniform number."""
        return int(self._open().spec.agents[0].rpartition("_")[2])

    def getNumTeammates(self) -> int:
        """Teammates without the agent."""
        return self._count()[0]

    def getNumOpponents(self) -> int:
        """Opponents."""
        return self._count()[1]

    def _count(self) -> List[int]:
        side = 1 if self._open().spec.agents[0].startswith("left") else -1
        sides = [one.side for one in self._open().pool.view(0).players if one.on_pitch]
        return [sides.count(side) - 1, sides.count(-side)]
