"""Worlds as a VecEnv of Stable-Baselines3 and sb3-contrib."""
from __future__ import annotations

from typing import Any, Dict, List, Optional, Sequence, Tuple, Type

import numpy as np
from stable_baselines3.common.monitor import Monitor
from stable_baselines3.common.vec_env import VecEnv

from cls_gym._api import AutoresetMode
from cls_gym._config import ConfigError
from cls_gym.adapters._common import check_vector
from cls_gym.vector import VectorEnv


class SB3VecEnv(VecEnv):  # type: ignore[misc,unused-ignore]
    """N worlds with A agents each as N A rows, world by world, for one policy that all share.

    envs: a VectorEnv with autoreset_mode="same_step" and actions that are no tuples. MaskablePPO
    finds `action_masks`. The last info of an episode has `terminal_observation`,
    `TimeLimit.truncated`, `episode` {r, l, t} of the row, and the `status` of the world. After a
    red card a row observes zeros until the episode ends. `set_options` holds until changed.
    """

    def __init__(self, envs: VectorEnv) -> None:
        self.envs = check_vector(envs, "Stable-Baselines3", AutoresetMode.SAME_STEP)
        self.render_mode = envs.render_mode
        spec, agents = envs.spec_of_task, envs.num_agents
        place = envs._worlds.mask_place or "info"
        self._agents = agents
        super().__init__(envs.num_envs * agents, spec.observation_space(1, place),
                         spec.actions.space(1))
        self._returns = np.zeros(self.num_envs, np.float64)
        self._lengths = np.zeros(self.num_envs, np.int64)
        self._cycles = 0
        self._actions: Any = None

    def _rows(self, value: Any) -> Any:
        """An array [N, ...] or [N, A, ...], or a dictionary of them, with a row per agent."""
        if isinstance(value, dict):
            return {key: self._rows(one) for key, one in value.items()}
        if self._agents == 1:
            return value
        return value.reshape(self.num_envs, *value.shape[2:])

    def seed(self, seed: Optional[int] = None) -> Sequence[Optional[int]]:
        """World i starts with seed + i at the next reset; its rows have the same number."""
        if seed is None:
            seed = int(np.random.default_rng().integers(2**31))
        worlds = range(seed, seed + self.envs.num_envs)
        self._seeds = [one for one in worlds for _ in range(self._agents)]
        return self._seeds

    def reset(self) -> Any:
        options = self._options[0]
        if any(one != options for one in self._options):
            raise ConfigError("set_options: the rows of SB3VecEnv have one set of options")
        seen, infos = self.envs.reset(seed=self._seeds[::self._agents], options=options)
        self._reset_seeds()
        self._reset_options()
        self._returns[...] = 0
        self._lengths[...] = 0
        self.reset_infos = [{"seed": int(infos["seed"][row // self._agents])}
                            for row in range(self.num_envs)]
        return self._rows(seen)

    def step_async(self, actions: np.ndarray) -> None:
        self._actions = actions

    def step_wait(self) -> Tuple[Any, np.ndarray, np.ndarray, List[Dict[str, Any]]]:
        actions = np.asarray(self._actions)
        if self._agents > 1:
            actions = actions.reshape(self.envs.num_envs, self._agents, *actions.shape[1:])
        seen, _, terminated, truncated, infos = self.envs.step(actions)
        rewards = self.envs.agent_rewards.reshape(-1)
        self._returns += rewards
        self._lengths += 1
        ended = terminated | truncated
        rows: List[Dict[str, Any]] = [{} for _ in range(self.num_envs)]
        for world in np.flatnonzero(ended):
            self._end(int(world), bool(terminated[world]), infos, rows)
        return self._rows(seen), rewards, np.repeat(ended, self._agents), rows

    def _end(self, world: int, terminated: bool, infos: Dict[str, Any],
             rows: List[Dict[str, Any]]) -> None:
        """Fills in the infos of the rows of a world whose episode has ended."""
        last = infos["final_obs"][world]
        for agent in range(self._agents):
            row = world * self._agents + agent
            own = last if self._agents == 1 else (
                {key: value[agent] for key, value in last.items()}
                if isinstance(last, dict) else last[agent])
            rows[row].update({
                "terminal_observation": own, "TimeLimit.truncated": not terminated,
                "status": int(infos["final_info"]["status"][world]),
                "episode": {"r": float(self._returns[row]), "l": int(self._lengths[row]),
                            "t": float(infos["final_info"]["cycles"][world])}})
            self._returns[row] = self._lengths[row] = 0

    def action_masks(self) -> np.ndarray:
        """bool[rows, K]: which ids have an effect now."""
        return np.stack(self.envs.action_masks()).reshape(self.num_envs, -1)

    def env_method(self, method_name: str, *method_args: Any, indices: Any = None,
                   **method_kwargs: Any) -> List[Any]:
        """`action_masks` of rows; there is no other method by row."""
        if method_name != "action_masks":
            raise AttributeError(f"SB3VecEnv: the rows share one engine and have no "
                                 f"{method_name!r}; its VectorEnv is envs")
        masks = self.action_masks()
        return [masks[row] for row in self._get_indices(indices)]

    def has_attr(self, attr_name: str) -> bool:
        if attr_name == "action_masks":
            return bool(self.envs.spec_of_task.actions.names)
        return hasattr(self.envs, attr_name)

    def get_attr(self, attr_name: str, indices: Any = None) -> List[Any]:
        """An attribute of the VectorEnv, for each row."""
        return [getattr(self.envs, attr_name) for _ in self._get_indices(indices)]

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        raise AttributeError(f"SB3VecEnv: the rows share one engine, so {attr_name!r} cannot be "
                             "set by row; give the VectorEnv other keywords")

    def env_is_wrapped(self, wrapper_class: Type[Any], indices: Any = None) -> List[bool]:
        """Only Monitor's record, `episode`, is in the infos."""
        return [issubclass(Monitor, wrapper_class) for _ in self._get_indices(indices)]

    def get_images(self) -> Sequence[Optional[np.ndarray]]:
        return list(self.envs.render() or ())

    def close(self) -> None:
        self.envs.close()
