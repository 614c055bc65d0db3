"""Worlds as a multi-agent environment of skrl, with N worlds in each call."""
from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

import numpy as np
import torch
from skrl import config
from skrl.envs.wrappers.torch.base import MultiAgentEnvWrapper

from cls_gym._api import AutoresetMode
from cls_gym._config import ConfigError
from cls_gym.adapters._common import check_vector
from cls_gym.vector import VectorEnv

Tensors = Dict[str, torch.Tensor]


class ClsMultiAgent(MultiAgentEnvWrapper):  # type: ignore[misc,unused-ignore]
    """N worlds; agents are "left_7", "right_1", ...

    envs: a VectorEnv with autoreset_mode="same_step", mask "info" or "appended", and actions that
    are no tuples. skrl has no action masks: an id without an effect acts as no action, and with
    "appended" a policy can learn which. skrl takes the first observation of the next episode as the
    last one of a truncated episode. The state for MAPPO's critic is the full state.
    """

    def __init__(self, envs: VectorEnv) -> None:
        check_vector(envs, "skrl", AutoresetMode.SAME_STEP)
        place = envs._worlds.mask_place or "info"
        if place == "observation":
            raise ConfigError("mask: skrl flattens dictionaries, masks and all; use \"info\" or "
                              "\"appended\"")
        super().__init__(envs)
        spec = envs.spec_of_task
        self._names = list(spec.agents)
        self._observation_spaces = {one: spec.observation_space(1, place) for one in self._names}
        self._action_spaces = {one: spec.actions.space(1) for one in self._names}
        self._state_space = spec.state_space()
        self._ids = bool(spec.actions.names)
        self._seed: Optional[int] = config.torch.key

    @property
    def agents(self) -> Any:
        return self._names

    @property
    def possible_agents(self) -> Any:
        return self._names

    @property
    def observation_spaces(self) -> Any:
        return self._observation_spaces

    @property
    def action_spaces(self) -> Any:
        return self._action_spaces

    @property
    def state_spaces(self) -> Any:
        return {one: self._state_space for one in self._names}

    def _by_agent(self, array: np.ndarray) -> Tensors:
        """float32[N, A, F] or [N, F] as a tensor for each agent."""
        rows = torch.as_tensor(array, device=self.device).reshape(
            self.num_envs, len(self._names), -1)
        return {one: rows[:, place] for place, one in enumerate(self._names)}

    def reset(self) -> Tuple[Tensors, Dict[str, Any]]:
        seen, _ = self._env.reset(seed=self._seed)
        self._seed = None
        return self._by_agent(seen), {one: {} for one in self._names}

    def step(self, actions: Tensors) -> Tuple[Tensors, Tensors, Tensors, Tensors, Dict[str, Any]]:
        parts = [actions[one].detach().cpu().numpy() for one in self._names]
        rows = np.stack([part[:, 0] if self._ids else part for part in parts], axis=1)
        seen, _, terminated, truncated, _ = self._env.step(
            rows if len(self._names) > 1 else rows[:, 0])
        ends = [torch.as_tensor(one, device=self.device)[:, None]
                for one in (terminated, truncated)]
        return (self._by_agent(seen), self._by_agent(self._env.agent_rewards),
                {one: ends[0] for one in self._names}, {one: ends[1] for one in self._names},
                {one: {} for one in self._names})

    def state(self) -> Any:
        state = torch.as_tensor(self._env.state(), device=self.device)
        return {one: state for one in self._names}

    def render(self, *_: Any, **__: Any) -> Any:
        return self._env.render()

    def close(self) -> None:
        self._env.close()
