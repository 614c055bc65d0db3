"""Worlds in groups, as EnvPool's send() and recv(): one group steps while the caller decides for
another."""
from __future__ import annotations

import collections
import concurrent.futures
from typing import Any, Deque, Dict, List, Optional, Tuple

import numpy as np

from cls_gym._api import ResetNeeded
from cls_gym._config import ActionError, ConfigError
from cls_gym.vector import VectorEnv

Batch = Tuple[Any, np.ndarray, np.ndarray, np.ndarray, Dict[str, Any]]


class Pipeline:
    """N worlds in `groups` of equal size, each a VectorEnv that steps in a thread of its own.

    >>> import cls_gym
    >>> worlds = cls_gym.Pipeline("cls/HFO-1v0-v0", num_envs=64, actions="low_discrete")
    >>> worlds.async_reset(seed=1)
    >>> for _ in range(4):
    ...     observations, rewards, terminations, truncations, infos = worlds.recv()
    ...     worlds.send(worlds.action_space.sample(infos["action_mask"]), infos["env_id"])
    >>> observations.shape, [int(infos["env_id"][0]), int(infos["env_id"][-1])]
    ((32, 59), [32, 63])
    >>> worlds.close()

    recv() returns what step() of the group that was sent first returned, or its observations after
    async_reset() with zeros; infos["env_id"] int32[N/groups] are its worlds. World i plays what
    world i of VectorEnv(task, num_envs, ...) plays. The engine does not hold Python's lock, so the
    two halves overlap; with `threads` each group has more. Keywords are those of VectorEnv.
    """

    def __init__(self, task: str = "cls/HFO-1v0-v0", num_envs: int = 2, *, groups: int = 2,
                 **config: Any) -> None:
        if groups < 1 or num_envs % groups:
            raise ConfigError(f"groups: num_envs={num_envs} is no multiple of {groups!r}")
        self.num_envs = num_envs
        self.groups: List[VectorEnv] = [VectorEnv(task, num_envs // groups, **config)
                                        for _ in range(groups)]
        size = num_envs // groups
        self._ids = [np.arange(size, dtype=np.int32) + size * group for group in range(groups)]
        self.spec_of_task = self.groups[0].spec_of_task
        self.single_observation_space = self.groups[0].single_observation_space
        self.single_action_space = self.groups[0].single_action_space
        #: Of the actions of one group.
        self.action_space = self.groups[0].action_space
        self._threads = concurrent.futures.ThreadPoolExecutor(groups)
        self._sent: Deque[Tuple[int, Any]] = collections.deque()

    def async_reset(self, seed: Optional[int] = None,
                    options: Optional[Dict[str, Any]] = None) -> None:
        """Starts episodes in all worlds, world i with seed + i; what was sent is dropped."""
        while self._sent:
            self._sent.popleft()[1].exception()
        for group, envs in enumerate(self.groups):
            first = None if seed is None else seed + int(self._ids[group][0])
            self._sent.append((group, self._threads.submit(_reset, envs, first, options)))

    def recv(self) -> Batch:
        """The result of the group that was sent first. Raises what its step has raised."""
        if not self._sent:
            raise ResetNeeded("recv: nothing was sent; async_reset() or send() first")
        group, future = self._sent.popleft()
        seen, rewards, terminated, truncated, infos = future.result()
        return seen, rewards, terminated, truncated, {**infos, "env_id": self._ids[group]}

    def send(self, actions: Any, env_id: Any) -> None:
        """Plays a step in the group whose worlds are `env_id`, as recv() has returned them."""
        group = int(np.asarray(env_id).flat[0]) // len(self._ids[0])
        if not 0 <= group < len(self.groups) or not np.array_equal(env_id, self._ids[group]):
            raise ActionError("send: env_id is no group; pass infos[\"env_id\"] of recv()")
        if any(one == group for one, _ in self._sent):
            raise ActionError(f"send: group {group} plays already; recv() first")
        self._sent.append((group, self._threads.submit(self.groups[group].step, actions)))

    def close(self) -> None:
        """Waits for what was sent and frees the worlds."""
        self._threads.shutdown()
        for envs in self.groups:
            envs.close()


def _reset(envs: VectorEnv, seed: Optional[int], options: Optional[Dict[str, Any]]) -> Batch:
    seen, infos = envs.reset(seed=seed, options=options)
    nothing = np.zeros(envs.num_envs, np.bool_)
    return seen, np.zeros(envs.num_envs, np.float64), nothing, nothing.copy(), infos
