"""Worlds as an EnvBase of TorchRL, in its conventions for several agents."""
from __future__ import annotations

from typing import Any, Optional

import numpy as np
import torch
from tensordict import TensorDict, TensorDictBase
from torchrl.data import Binary, Bounded, Categorical, Composite, Unbounded
from torchrl.envs import EnvBase

from cls_gym._api import AutoresetMode
from cls_gym._config import ConfigError
from cls_gym.adapters._common import check_vector
from cls_gym.vector import VectorEnv


class ClsEnv(EnvBase):  # type: ignore[misc,unused-ignore]
    """N worlds with A agents each: batch [N], and below "agents" [N, A].

    envs: a VectorEnv with autoreset_mode="disabled", mask="info" and actions that are no tuples.
    Keys: agents/observation float32[N, A, F], agents/action int64[N, A] (or float32[N, A, V] for
    "low_flat"), agents/action_mask bool[N, A, K] for torchrl's ActionMask, agents/alive bool[N, A]
    (false after a red card: leave those rows out of a loss), agents/reward float32[N, A, 1], state
    float32[N, S] for a central critic, status int64[N, 1], done, terminated, truncated [N, 1].
    reset() of a tensordict with "_reset" starts episodes in some worlds.
    """

    batch_locked = True

    def __init__(self, envs: VectorEnv, device: Any = "cpu") -> None:
        self.envs = check_vector(envs, "TorchRL", AutoresetMode.DISABLED)
        if envs._worlds.mask_place not in (None, "info"):
            raise ConfigError("mask: TorchRL's ActionMask reads agents/action_mask; use \"info\"")
        super().__init__(device=device, batch_size=[envs.num_envs])
        spec = envs.spec_of_task
        shape = (envs.num_envs, envs.num_agents)
        self._ids = len(spec.actions.names)
        agents = {"observation": self._bounded(spec.observation_space(1), shape),
                  "alive": Categorical(2, shape=shape, dtype=torch.bool, device=self.device)}
        if self._ids:
            agents["action_mask"] = Binary(shape=(*shape, self._ids), dtype=torch.bool,
                                           device=self.device)
            action: Any = Categorical(self._ids, shape=shape, device=self.device)
        else:
            action = self._bounded(spec.actions.space(1), shape)
        self.observation_spec = Composite(
            agents=Composite(agents, shape=shape, device=self.device),
            state=self._bounded(spec.state_space(), shape[:1]),
            status=Unbounded(shape=(shape[0], 1), dtype=torch.int64, device=self.device),
            shape=shape[:1], device=self.device)
        self.action_spec = Composite(agents=Composite(action=action, shape=shape),
                                     shape=shape[:1], device=self.device)
        self.reward_spec = Composite(
            agents=Composite(reward=Unbounded(shape=(*shape, 1), device=self.device), shape=shape),
            shape=shape[:1], device=self.device)
        flag = Categorical(2, shape=(shape[0], 1), dtype=torch.bool, device=self.device)
        self.done_spec = Composite(done=flag, terminated=flag.clone(), truncated=flag.clone(),
                                   shape=shape[:1], device=self.device)

    def _bounded(self, space: Any, shape: Any) -> Bounded:
        low, high = (torch.as_tensor(np.broadcast_to(one, (*shape, *one.shape)).copy())
                     for one in (space.low, space.high))
        return Bounded(low=low, high=high, shape=low.shape, dtype=torch.float32,
                       device=self.device)

    def _set_seed(self, seed: Optional[int]) -> None:
        self._seed = seed

    def _reset(self, tensordict: Optional[TensorDictBase] = None, **_: Any) -> TensorDictBase:
        which = None if tensordict is None else tensordict.get("_reset", None)
        options = {}
        if which is not None and not which.all():
            options = {"reset_mask": which.reshape(-1).cpu().numpy()}
        seed, self._seed = getattr(self, "_seed", None), None
        seen, infos = self.envs.reset(seed=seed, options=options)
        result = self._observed(seen, infos)
        nobody = torch.zeros((*self.batch_size, 1), dtype=torch.bool, device=self.device)
        return result.update({key: nobody.clone() for key in ("done", "terminated", "truncated")})

    def _step(self, tensordict: TensorDictBase) -> TensorDictBase:
        actions = tensordict["agents", "action"].cpu().numpy()
        if self.envs.num_agents == 1:
            actions = actions[:, 0]
        seen, _, terminated, truncated, infos = self.envs.step(actions)
        result = self._observed(seen, infos)
        result["agents", "reward"] = self._tensor(self.envs.agent_rewards[..., None])
        for name, value in (("done", terminated | truncated), ("terminated", terminated),
                            ("truncated", truncated)):
            result[name] = self._tensor(value[:, None])
        return result

    def _observed(self, seen: np.ndarray, infos: Any) -> TensorDict:
        shape = (self.envs.num_envs, self.envs.num_agents)
        agents = {"observation": self._tensor(seen.reshape(*shape, -1)),
                  "alive": self._tensor(self.envs.alive)}
        if self._ids:
            # An action must be legal; after the end, where none is played, all are.
            legal = infos["action_mask"].reshape(*shape, -1) != 0
            legal |= ~legal.any(axis=-1, keepdims=True)
            agents["action_mask"] = self._tensor(legal)
        return TensorDict({
            "agents": TensorDict(agents, batch_size=shape, device=self.device),
            "state": self._tensor(self.envs.state()),
            "status": self._tensor(infos["status"].astype(np.int64)[:, None])},
            batch_size=self.batch_size, device=self.device)

    def _tensor(self, array: np.ndarray) -> torch.Tensor:
        return torch.as_tensor(array, device=self.device)

    def close(self, *, raise_if_closed: bool = True) -> None:
        self.envs.close()
        super().close(raise_if_closed=raise_if_closed)
