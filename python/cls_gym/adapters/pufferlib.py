"""Worlds as a native environment of PufferLib 3."""
from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

import numpy as np
import pufferlib

from cls_gym._config import ConfigError
from cls_gym._worlds import Worlds
from cls_gym.adapters._common import refuse_tuples
from cls_gym.seeding import SeedQueues, seed_list

Result = Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, List[Dict[str, Any]]]


class PufferCls(pufferlib.PufferEnv):  # type: ignore[misc,unused-ignore]
    """N worlds with A agents each as N A rows, world by world, in PufferLib's buffers.

    num_envs: N. Other keywords are those of VectorEnv. PufferLib has no action masks: with
    mask="appended" (default) they are the end of each row, for policies that read them; with "info"
    there are none, and the engine writes observations into PufferLib's array without a copy.
    `masks` is false for players who were sent off. Episodes begin again in the step that ends them;
    infos then has the mean `return` and `cycles` of those that ended, and the share of `goals`.
    """

    def __init__(self, task: str = "cls/HFO-2v1-v0", num_envs: int = 64, *, mask: str = "appended",
                 buf: Any = None, seed: int = 0, **config: Any) -> None:
        if mask == "observation":
            raise ConfigError("mask: PufferLib has no observations that are dictionaries; use "
                              "\"appended\" or \"info\"")
        worlds = Worlds(task, num_envs, config, mask=mask, autoreset="same_step",
                        owner="PufferCls", own=("num_envs", "buf", "seed"))
        refuse_tuples(worlds.spec, "PufferLib")
        self.worlds = worlds
        self.num_agents = num_envs * worlds.agents
        self.single_observation_space = worlds.spec.observation_space(1, mask)
        self.single_action_space = worlds.spec.actions.space(1)
        super().__init__(buf)
        self._shape = (num_envs, worlds.agents)
        self._ids = bool(worlds.spec.actions.names)
        self._features = len(worlds.spec.features)
        self._seeds = SeedQueues(num_envs)
        self._first = seed
        worlds.pool.bind(next_seeds=self._seeds.next, rewards=self.rewards)
        if worlds.mask_place != "appended":
            worlds.pool.bind(observations=self.observations)
        self._returns = np.zeros(num_envs)

    def reset(self, seed: Optional[int] = None) -> Tuple[np.ndarray, List[Dict[str, Any]]]:
        count = self._shape[0]
        for index, one in enumerate(seed_list(self._first if seed is None else seed, count)):
            assert one is not None
            self._seeds.start(index, one)
        self.worlds.reset(None, self._seeds.next, None)
        self._seeds.take(None)
        self._returns[...] = 0
        self.rewards[...] = 0
        self.terminals[...] = self.truncations[...] = False
        self._show()
        return self.observations, []

    def step(self, actions: np.ndarray) -> Result:
        pool = self.worlds.pool
        rows = np.asarray(actions).reshape(*self._shape, -1)
        if self._ids:
            rows = rows[..., 0]
        self.worlds.set_actions(rows if self._shape[1] > 1 else rows[:, 0])
        if self.worlds.step():
            self._seeds.take(pool.was_reset)
        self._returns += pool.rewards.mean(axis=1)
        self.terminals[...] = np.repeat(pool.terminated, self._shape[1])
        self.truncations[...] = np.repeat(pool.truncated, self._shape[1])
        self._show()
        return (self.observations, self.rewards, self.terminals, self.truncations,
                self._summary(pool.terminated | pool.truncated))

    def _show(self) -> None:
        pool = self.worlds.pool
        self.masks[...] = pool.alive.reshape(self.masks.shape)
        if self.worlds.mask_place == "appended":
            rows = self.observations.reshape(*self._shape, -1)
            rows[..., :self._features] = pool.observations
            rows[..., self._features:] = pool.action_masks

    def _summary(self, ended: np.ndarray) -> List[Dict[str, Any]]:
        """Infos: one dictionary of means over the episodes that have ended, if any."""
        if not ended.any():
            return []
        pool = self.worlds.pool
        info = {"return": float(self._returns[ended].mean()),
                "cycles": float(pool.cycles[ended].mean()),
                "goals": float((pool.status[ended] == 1).mean())}
        self._returns[ended] = 0
        return [info]

    def close(self) -> None:
        self.worlds.close()
