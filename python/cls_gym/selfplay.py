"""Worlds against frozen policies: one call per policy decides for all its players of all worlds."""
from __future__ import annotations

from typing import Any, Callable, Dict, List, Sequence, Tuple, Union

import numpy as np

from cls_gym._config import ConfigError
from cls_gym.policy import Policy, PolicyError, describe, misfit
from cls_gym.vector import VectorEnv

TASK = "cls/Match-v0"
#: Two players per side; an episode ends with the first goal.
CONFIG: Dict[str, Any] = {"offense": 2, "defense": 2, "features": "ego",
                          "actions": "low_discrete", "max_cycles": 600,
                          "options": {"stop_play": 1}}
#: Actions int64[rows] of observations float32[rows, F] and masks int8[rows, K].
Act = Callable[[np.ndarray, np.ndarray], np.ndarray]
Frozen = Union[Policy, Act]
#: One policy, or several with their weights.
Pool = Union[Frozen, Sequence[Tuple[Frozen, float]]]
Step = Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, Dict[str, Any]]


class _Drawn:
    """Policies by world: drawn for each episode by its seed."""

    def __init__(self, pool: Pool, name: str, stream: int) -> None:
        shares: Any = pool if isinstance(pool, (list, tuple)) else [(pool, 1.0)]
        weights = np.array([weight for _, weight in shares], np.float64)
        if not len(shares) or not np.isfinite(weights).all() or (weights < 0).any() \
                or weights.sum() <= 0:
            raise ConfigError(f"{name}: needs policies with weights, some of them above 0")
        self.policies: List[Frozen] = [one for one, _ in shares]
        self._acts: List[Act] = [one.act if isinstance(one, Policy) else one
                                 for one in self.policies]
        self._chances = np.cumsum(weights / weights.sum())
        self._stream = stream

    def index(self, seed: int) -> int:
        """Which policy plays the episode with this seed."""
        draw = np.random.default_rng([int(seed), self._stream]).random()
        return min(int(np.searchsorted(self._chances, draw, side="right")), len(self._acts) - 1)

    def act(self, drawn: np.ndarray, seen: np.ndarray, mask: np.ndarray) -> np.ndarray:
        """int64[N, P] for float32[N, P, F], where world i plays policy drawn[i]."""
        actions = np.zeros(seen.shape[:2], np.int64)
        for number, act in enumerate(self._acts):
            own = np.flatnonzero(drawn == number)
            if len(own):
                rows = act(seen[own].reshape(-1, seen.shape[2]),
                           mask[own].reshape(-1, mask.shape[2]))
                actions[own] = rows.reshape(len(own), -1)
        return actions


class SelfPlay:
    """Worlds in which frozen policies play the right team, and players of the left team that the
    caller does not play. Shapes as those of VectorEnv for the caller's agents alone; rewards are
    per agent, float32[N, A]. autoreset_mode is "same_step".

    opponent: a policy, or [(policy, weight), ...]: each episode draws one by its seed;
    infos["opponent"] is its index. teammates: the same for the left players beyond `num_agents`.
    A policy is a Policy or a function of observations [rows, F] and masks [rows, K]. All its
    players of all worlds are rows of one call per step.
    """

    def __init__(self, opponent: Pool, num_envs: int, *, task: str = TASK,
                 teammates: Union[Pool, None] = None, num_agents: Union[int, None] = None,
                 **config: Any) -> None:
        settings = {**CONFIG, **config} if task == TASK else config
        self.envs = VectorEnv(task, num_envs, **{**settings, "agents": "both"},
                              autoreset_mode="same_step")
        if self.envs.spec_of_task.actions.senses:
            raise ConfigError("look, say: policies of SelfPlay choose ids alone")
        names = self.envs.spec_of_task.agents
        self._left = sum(agent.startswith("left") for agent in names)
        self.agents = self._left if num_agents is None else num_agents
        if not 1 <= self.agents <= self._left or self._left == len(names):
            raise ConfigError(f"num_agents: 1 to {self._left}, and opponents on the pitch")
        if (teammates is None) != (self.agents == self._left):
            raise ConfigError("teammates: policies for the players beyond num_agents, if any")
        self._opponents = _Drawn(opponent, "opponent", 1)
        self._teammates = None if teammates is None else _Drawn(teammates, "teammates", 2)
        for drawn in (self._opponents, self._teammates):
            if drawn is not None:
                self._check_fit(drawn)
        self._drawn = np.zeros((2, num_envs), np.int64)  # opponents, teammates

    def _check_fit(self, drawn: _Drawn) -> None:
        for policy in drawn.policies:
            reason = misfit(policy, describe(self.envs)) if isinstance(policy, Policy) else None
            if reason:
                raise PolicyError(f"a policy of other worlds: {reason}")

    def reset(self, seed: int) -> Tuple[np.ndarray, Dict[str, Any]]:
        """Starts episodes in all worlds."""
        self._seen, self._infos = self.envs.reset(seed=seed)
        self._draw(np.ones(self.envs.num_envs, np.bool_))
        return self._own()

    def step(self, actions: np.ndarray) -> Step:
        """`actions`: int64[N, A] of the caller's agents."""
        seen, mask = self._seen, self._infos["action_mask"]
        parts = [np.asarray(actions).reshape(len(seen), self.agents)]
        if self._teammates is not None:
            others = slice(self.agents, self._left)
            parts.append(self._teammates.act(self._drawn[1], seen[:, others], mask[:, others]))
        right = slice(self._left, None)
        parts.append(self._opponents.act(self._drawn[0], seen[:, right], mask[:, right]))
        played = self._drawn[0].copy()
        self._seen, _, terminated, truncated, self._infos = self.envs.step(
            np.concatenate(parts, axis=1))
        ended = terminated | truncated
        if ended.any():
            self._infos["final_info"]["opponent"] = np.where(ended, played, 0)
            self._draw(ended)
        seen, infos = self._own()
        return seen, self.envs.agent_rewards[:, :self.agents], terminated, truncated, infos

    def _draw(self, which: np.ndarray) -> None:
        for world in np.flatnonzero(which):
            seed = self._infos["seed"][world]
            self._drawn[0, world] = self._opponents.index(seed)
            if self._teammates is not None:
                self._drawn[1, world] = self._teammates.index(seed)

    def _own(self) -> Tuple[np.ndarray, Dict[str, Any]]:
        infos = dict(self._infos, opponent=self._drawn[0].copy(),
                     action_mask=self._infos["action_mask"][:, :self.agents])
        return self._seen[:, :self.agents], infos

    def close(self) -> None:
        """Frees the worlds."""
        self.envs.close()
