"""Self-play: snapshots of policies, their results against each other, opponents to train with.

>>> import numpy as np
>>> from cls_gym import VectorEnv
>>> from cls_gym.league import CONFIG, TASK, League, SelfPlay
>>> from cls_gym.policy import Policy, describe
>>> about = describe(VectorEnv(TASK, **CONFIG, agents="both"))
>>> shape = len(about["feature_names"]), len(about["action_names"])
>>> first, second = [Policy([(np.full(shape, x), np.zeros(shape[1]))], about) for x in (0, 1)]
>>> league = League("league")
>>> league.add(first), league.add(second)  # snapshots
(1, 2)
>>> opponent = league.opponent(2, "pfsp")  # the one to train against next
>>> envs = SelfPlay(league.policy(opponent), num_envs=64)
>>> league.play(1, 2, episodes=4)
Results(wins=0, draws=4, losses=0)
>>> league.close()

Episodes of a league are short matches with the same number of players on both sides; a policy of
the feature set "ego" plays either side. compare() plays whole matches: it calls `cls compare`.
"""
from __future__ import annotations

import json
import os
import pathlib
import sqlite3
import subprocess
import sys
from typing import Any, Dict, List, NamedTuple, Sequence, Union

import numpy as np

from cls_gym.policy import Policy, PolicyError, describe, load, misfit
from cls_gym.selfplay import CONFIG, TASK, SelfPlay
from cls_gym.vector import VectorEnv

__all__ = ["CONFIG", "TASK", "League", "LeagueError", "Results", "SelfPlay", "play_episodes"]
#: Of results.sqlite.
VERSION = 1
SAMPLINGS = ("latest", "uniform", "pfsp")


class LeagueError(RuntimeError):
    """A league without policies or of a later version, or a comparison that did not run."""


class Results(NamedTuple):
    """Episodes of one policy against another one."""

    wins: int
    draws: int
    losses: int

    @property
    def share(self) -> float:
        """Points per episode: a win 1, a draw 0.5; 0.5 without episodes."""
        count = sum(self)
        return (self.wins + 0.5 * self.draws) / count if count else 0.5


class League:
    """A folder with snapshot-1.npz, snapshot-2.npz, ... and results.sqlite."""

    def __init__(self, folder: Union[str, pathlib.Path], **config: Any) -> None:
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.config = {**CONFIG, **config}
        self._results = sqlite3.connect(self.folder / "results.sqlite")
        self._check_version()
        self._results.execute("create table if not exists episodes (home integer, away integer, "
                              "seed integer, home_goals integer, away_goals integer)")

    def _check_version(self) -> None:
        """Leagues without a version are of the first one."""
        [version] = self._results.execute("pragma user_version").fetchone()
        if version > VERSION:
            self._results.close()
            raise LeagueError(f"{self.folder / 'results.sqlite'}: version {version} is newer than "
                              f"this cls_gym reads ({VERSION}); update cls")
        self._results.execute(f"pragma user_version = {VERSION}")

    def numbers(self) -> List[int]:
        """The snapshots, ascending from 1."""
        return sorted(int(path.stem.rpartition("-")[2])
                      for path in self.folder.glob("snapshot-*.npz"))

    def path(self, number: int) -> pathlib.Path:
        return self.folder / f"snapshot-{number}.npz"

    def add(self, policy: Union[Policy, str, pathlib.Path]) -> int:
        """Stores a snapshot, a Policy or a file of one; returns its number. PolicyError: it does
        not play the worlds of this league."""
        if not isinstance(policy, Policy):
            policy = load(policy)
        with VectorEnv(TASK, 1, **{**self.config, "agents": "both"}) as envs:
            reason = misfit(policy, describe(envs))
        if reason:
            raise PolicyError(f"{self.folder}: a policy of another league: {reason}")
        number = max(self.numbers(), default=0) + 1
        policy.save(self.path(number))
        return number

    def policy(self, number: int) -> Policy:
        return load(self.path(number))

    def play(self, one: int, other: int, episodes: int, seed: int = 1) -> Results:
        """Plays episodes, each policy on either side in half of them, and stores the results.
        Returns those of `one`."""
        totals = np.zeros(3, np.int64)
        half = (episodes + 1) // 2
        for home, away, count, first in ((one, other, half, seed),
                                         (other, one, episodes - half, seed + half)):
            if not count:
                continue
            goals = play_episodes(self.policy(home), self.policy(away), count, first, self.config)
            self._store(home, away, first, goals)
            sign = np.sign(goals[:, 0] - goals[:, 1]) * (1 if home == one else -1)
            totals += [(sign > 0).sum(), (sign == 0).sum(), (sign < 0).sum()]
        return Results(*totals.tolist())

    def _store(self, home: int, away: int, seed: int, goals: np.ndarray) -> None:
        rows = [(home, away, seed + i, int(h), int(a)) for i, (h, a) in enumerate(goals)]
        with self._results:
            self._results.executemany("insert into episodes values (?, ?, ?, ?, ?)", rows)

    def results(self, one: int, other: int) -> Results:
        """All stored episodes of `one` against `other`, on either side."""
        row = self._results.execute(
            "select coalesce(sum(goals > 0), 0), coalesce(sum(goals = 0), 0), "
            "coalesce(sum(goals < 0), 0) from (select home_goals - away_goals as goals "
            "from episodes where home = :one and away = :other union all select "
            "away_goals - home_goals from episodes where home = :other and away = :one)",
            {"one": one, "other": other}).fetchone()
        return Results(*row)

    def payoff(self) -> np.ndarray:
        """float64[n, n]: points per episode of the row's policy against the column's; 0.5 on the
        diagonal and where no episode was played."""
        numbers = self.numbers()
        table = np.full((len(numbers), len(numbers)), 0.5)
        for row, one in enumerate(numbers):
            for column, other in enumerate(numbers):
                if one != other:
                    table[row, column] = self.results(one, other).share
        return table

    def weights(self, learner: int, sampling: str = "pfsp") -> np.ndarray:
        """float64[n]: the chance of each snapshot but the learner's to be its next opponent.
        "pfsp": the square of the points that the learner loses against it (prioritized fictitious
        self-play), so that opponents it beats always are no longer chosen."""
        if sampling not in SAMPLINGS:
            raise ValueError(f"sampling: unknown {sampling!r}; one of {', '.join(SAMPLINGS)}")
        numbers = self.numbers()
        others = np.array([number != learner for number in numbers])
        if not others.any():
            raise LeagueError(f"{self.folder}: no snapshot but {learner}; add() another one")
        chances = others.astype(np.float64)
        if sampling == "latest":
            chances[:] = 0.0
            chances[np.flatnonzero(others)[-1]] = 1.0
        elif sampling == "pfsp":
            lost = np.array([1.0 - self.results(learner, number).share for number in numbers])
            hard = others * lost ** 2
            chances = hard if hard.sum() > 0 else chances
        shares: np.ndarray = chances / chances.sum()
        return shares

    def opponent(self, learner: int, sampling: str = "pfsp",
                 random: Union[np.random.Generator, int] = 0) -> int:
        """A snapshot to train against, drawn by weights()."""
        generator = np.random.default_rng(random)
        return int(generator.choice(self.numbers(), p=self.weights(learner, sampling)))

    def compare(self, new: int, base: int, options: Sequence[str] = (), cls: str = "cls"
                ) -> Dict[str, Any]:
        """Whole matches: `cls compare` of two snapshots, its document "cls.compare/1". `options`
        are those of the command; the same call resumes. Snapshots that were trained with the full
        state are refused: these matches are rated."""
        sides = [f"run:{sys.executable} -m cls_gym.play --who all {self.path(number).resolve()} "
                 "--port {port}" for number in (new, base)]
        package = str(pathlib.Path(__file__).resolve().parents[1])
        environment = dict(os.environ)
        environment["PYTHONPATH"] = os.pathsep.join(
            [package, *filter(None, [os.environ.get("PYTHONPATH")])])
        done = subprocess.run([cls, "compare", *sides, "--json", *options], env=environment,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              check=False)
        if done.returncode not in (0, 1, 3) or not done.stdout:
            raise LeagueError(f"cls compare: exit code {done.returncode}: {done.stderr.strip()}")
        document: Dict[str, Any] = json.loads(done.stdout)
        if document["counts"]["invalid"] and not document["counts"]["finished"]:
            raise LeagueError(f"cls compare: {document['matches'][0]['message']}")
        return document

    def __reduce__(self) -> Any:
        return _open, (str(self.folder.resolve()), self.config)

    def close(self) -> None:
        self._results.close()


def _open(folder: str, config: Dict[str, Any]) -> League:
    return League(folder, **config)


def play_episodes(home: Policy, away: Policy, episodes: int, seed: int,
                  config: Dict[str, Any]) -> np.ndarray:
    """int64[episodes, 2]: goals of the left and the right team; episode i has seed + i."""
    envs = VectorEnv(TASK, episodes, **{**config, "agents": "both"}, autoreset_mode="same_step")
    seen, infos = envs.reset(seed=seed)
    left = sum(agent.startswith("left") for agent in envs.spec_of_task.agents)
    goals = np.zeros((episodes, 2), np.int64)
    running = np.ones(episodes, np.bool_)
    while running.any():
        mask = infos["action_mask"]
        actions = np.concatenate([home.act(seen[:, :left], mask[:, :left]),
                                  away.act(seen[:, left:], mask[:, left:])], axis=1)
        seen, _, terminated, truncated, infos = envs.step(actions)
        ended = running & (terminated | truncated)
        if ended.any():
            goals[ended] = infos["final_info"]["score"][ended]
        running &= ~ended
    envs.close()
    return goals
