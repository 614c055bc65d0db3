"""Whole matches against any team of `cls match`, external teams over UDP too: slow.

>>> from cls_gym.match import MatchEnv
>>> env = MatchEnv("mock", options=["--cycles", "60"])  # or "team:teams/helios", ...
>>> observation, info = env.reset(seed=1)
>>> observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
>>> observation.shape
(10, 241)
>>> env.close()

Each episode is a process, `cls match`, whose left team asks this one; the numbers are those of
obs="world_model" in cls/Match-v0. A step takes milliseconds, with an external team tens of
milliseconds, and against one the episode is not a function of its seed: for training use
cls_gym.VectorEnv, for evaluation and the last hours of training this. It needs cls_playmaker.
"""
from __future__ import annotations

import json
import pathlib
import queue
import subprocess
import tempfile
from typing import Any, Dict, Optional, Sequence, Tuple

import numpy as np

from cls_gym import play, spaces
from cls_gym._api import BaseEnv, ClosedEnvironmentError, ResetNeeded
from cls_gym._config import ConfigError, EngineError
from cls_gym._worlds import Worlds
from cls_gym.seeding import episode_seed

PLAYERS = 10  # field players, uniform numbers 2 to 11


class MatchEnv(BaseEnv):  # type: ignore[misc]
    """The ten field players of the left team in whole matches.

    observation: float32[10, F], by uniform number from 2; zeros for a player that does not decide.
    action: int64[10]. Both exist in play_on; set plays and the goalie are skills of cls.
    reward: 1 for a goal, -1 for one of the opponents. An episode terminates with the match.
    info: `action_mask` int8[10, K], `cycle`, `score`, `skipped`: cycles of play_on without a
    decision since the last step (over UDP the server waits 1.25 s for a team, then play continues).

    opponent: a side of `cls match`: "mock", "mock:planner", "HOST:PORT", "team:DIR" (over UDP).
    options: further ones of `cls match`, such as ("--half-time", "60").
    """

    metadata: Dict[str, Any] = {"render_modes": []}

    def __init__(self, opponent: str = "mock", *, features: str = "ego",
                 actions: str = "low_discrete", options: Sequence[str] = (), cls: str = "cls"
                 ) -> None:
        try:
            import cls_playmaker
        except ImportError as error:
            raise ImportError(f"cls_gym.match: {error}; install the package: pip install ./python"
                              ) from error
        worlds = Worlds("cls/Match-v0", 1, {"features": features, "actions": actions,
                                            "num_agents": PLAYERS, "obs": "world_model"})
        worlds.close()
        self.spec_of_task = worlds.spec
        kinds = worlds.spec.actions
        if kinds.values:
            raise ConfigError(f"actions: {actions} has numbers; MatchEnv takes ids alone")
        self.observation_space: spaces.Space[Any] = worlds.observation_space
        self.action_space: spaces.Space[Any] = worlds.action_space
        self._form = cls_playmaker.RowForm(
            f"{worlds.spec.feature_set}/{worlds.spec.feature_version}",
            f"{kinds.name}/{kinds.version}", 10, 11)
        self._command = [cls, "match"]
        self._side = opponent
        self._options = list(options)
        self._asked: "queue.Queue[Any]" = queue.Queue()
        self._chosen: "queue.Queue[Any]" = queue.Queue()
        self._server, self._port = cls_playmaker.start(self._team(cls_playmaker))
        self._match: Optional[subprocess.Popen[str]] = None
        self._folder: Optional[tempfile.TemporaryDirectory[str]] = None
        self._rows: Any = None
        self._score = [0, 0]
        self._mode = ""  # of play, at the last call
        self._paid = 0   # goal difference in rewards so far
        self._cycle = self._skipped = 0
        self._closed = False

    def _team(self, package: Any) -> Any:
        env = self
        proto = package.proto

        class Team(package.Playmaker):  # type: ignore[misc,name-defined,unused-ignore]
            """Hands decisions in play_on to step()."""

            row_form = env._form

            def GetTeamRows(self, rows: Any) -> Any:
                skills = {unum: play.skill(proto, unum, rows.play_mode) for unum in rows.players}
                env._note(rows.play_mode, rows.cycle)
                if rows.play_mode != "play_on":
                    return package.TeamActions(b"", 1, skills)
                env._asked.put(rows)
                ids = env._chosen.get()
                if ids is None:  # the episode is over for step()
                    return package.TeamActions(b"", 1, skills)
                replies = {unum: skill for unum, skill in skills.items() if unum == play.GOALIE}
                chosen = [0 if unum == play.GOALIE else ids[unum - 2] for unum in rows.players]
                return package.TeamActions(np.array(chosen, "<f4").tobytes(), 1, replies)

        return Team()

    def _note(self, play_mode: str, cycle: int) -> None:
        """Counts goals, which the play mode names, and the cycles of play_on without a call."""
        if play_mode in ("goal_l", "goal_r") and self._mode != play_mode:
            self._score[play_mode == "goal_r"] += 1
        if play_mode == self._mode == "play_on":
            self._skipped += cycle - self._cycle - 1
        self._mode, self._cycle = play_mode, cycle

    def reset(self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
              ) -> Tuple[np.ndarray, Dict[str, Any]]:
        """Starts a match and returns its first decision."""
        self._check_open()
        super().reset(seed=seed)
        self._end_match()
        self._asked, self._chosen = queue.Queue(), queue.Queue()
        self._score, self._mode, self._paid = [0, 0], "", 0
        self._cycle, self._skipped = 0, 0
        self._folder = tempfile.TemporaryDirectory(prefix="cls-gym-")
        match = [*self._command, f"127.0.0.1:{self._port}", self._side, "--dir",
                 str(pathlib.Path(self._folder.name) / "match"), "--quiet", "--seed",
                 str(episode_seed(self.np_random) >> 33), *self._options]
        self._match = subprocess.Popen(match, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.PIPE, text=True)
        self._rows = self._next_rows()
        if self._rows is None:
            raise self._failure()
        return self._observation(), self._info(0)

    def step(self, action: Any) -> Tuple[np.ndarray, float, bool, bool, Dict[str, Any]]:
        """Plays until the next decision in play_on."""
        self._check_open()
        if self._rows is None:
            raise ResetNeeded("step: call reset() first")
        ids = np.asarray(action)
        if ids.shape != (PLAYERS,) or not self.action_space.contains(ids.astype(np.int64)):
            raise ConfigError(f"action: {PLAYERS} ids below {len(self.spec_of_task.actions.names)}")
        self._skipped = 0
        self._chosen.put(ids)
        self._rows = self._next_rows()
        over = self._rows is None
        if over:
            self._finish()
        difference = self._score[0] - self._score[1]
        reward, self._paid = float(difference - self._paid), difference
        skipped = 0 if over else self._skipped
        observation = self._nothing() if over else self._observation()
        return observation, reward, over, False, self._info(skipped)

    def _next_rows(self) -> Any:
        """The next decision; None: the match is over."""
        assert self._match is not None
        while True:
            try:
                return self._asked.get(timeout=0.2)
            except queue.Empty:
                if self._match.poll() is not None:
                    return None

    def _finish(self) -> None:
        """Takes the score of the ended match."""
        assert self._match is not None and self._folder is not None
        if self._match.wait() != 0:
            raise self._failure()
        result = pathlib.Path(self._folder.name) / "match" / "result.json"
        document = json.loads(result.read_text(encoding="utf-8"))
        self._score = [document[side]["score"] for side in ("left", "right")]

    def _failure(self) -> EngineError:
        assert self._match is not None and self._match.stderr is not None
        text = self._match.stderr.read().strip() or f"exit code {self._match.returncode}"
        return EngineError(f"cls match: {text}")

    def _columns(self, data: bytes, kind: Any, into: np.ndarray) -> np.ndarray:
        """Rows of the players 2 to 11."""
        rows = np.frombuffer(data, kind).reshape(len(self._rows.players), -1)
        for unum, row in zip(self._rows.players, rows):
            if unum != play.GOALIE:
                into[unum - 2] = row
        return into

    def _observation(self) -> np.ndarray:
        return self._columns(self._rows.features, "<f4", self._nothing())

    def _nothing(self) -> np.ndarray:
        """The observation of players that do not decide."""
        return np.zeros(self.observation_space.shape or (), np.float32)

    def _info(self, skipped: int) -> Dict[str, Any]:
        ids = len(self.spec_of_task.actions.names)
        mask = np.zeros((PLAYERS, ids), np.int8)
        cycle = -1
        if self._rows is not None:
            self._columns(self._rows.masks, np.int8, mask)
            cycle = self._rows.cycle
        return {"action_mask": mask, "cycle": cycle, "score": np.array(self._score, np.int32),
                "skipped": skipped}

    def _check_open(self) -> None:
        if self._closed:
            raise ClosedEnvironmentError("the environment is closed")

    def _end_match(self) -> None:
        self._rows = None
        if self._match is None:
            return
        self._match.terminate()
        self._chosen.put(None)
        assert self._match.stderr is not None
        self._match.stderr.read()
        self._match.wait()
        self._match.stderr.close()
        self._match = None
        if self._folder is not None:
            self._folder.cleanup()

    def __reduce__(self) -> Any:
        raise TypeError("MatchEnv: a match runs in other processes and cannot be copied; make a "
                        "MatchEnv where it is needed")

    def close(self) -> None:
        """Ends the match and the server; may be called again."""
        if not self._closed:
            self._closed = True
            self._end_match()
            self._server.stop(0).wait()
