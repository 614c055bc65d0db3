"""A world as a MultiAgentEnv of RLlib, and a module for policies that respect action masks."""
from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

import gymnasium
from ray.rllib.algorithms.ppo.torch.default_ppo_torch_rl_module import DefaultPPOTorchRLModule
from ray.rllib.core.columns import Columns
from ray.rllib.env.multi_agent_env import MultiAgentEnv
from ray.rllib.utils.torch_utils import FLOAT_MIN

from cls_gym._config import ConfigError
from cls_gym.parallel import ParallelEnv


class ClsMultiAgentEnv(MultiAgentEnv):  # type: ignore[misc,unused-ignore]
    """A task whose agents RLlib decides for by name: "left_7", ...

    config: the keywords of ParallelEnv. RLlib steps its copies one after the other in Python and
    asks for actions in each step: frame_skip=4 or more is advisable. With mask="observation" and
    MaskedModule policies choose legal ids alone. A red card ends the episode of one agent.
    """

    def __init__(self, config: Optional[Dict[str, Any]] = None) -> None:
        super().__init__()
        self.env = ParallelEnv(**dict(config or {}))
        self.possible_agents = list(self.env.possible_agents)
        self.agents = list(self.possible_agents)
        self.observation_spaces = {one: self.env.observation_space(one) for one in self.agents}
        self.action_spaces = {one: self.env.action_space(one) for one in self.agents}
        self.observation_space = gymnasium.spaces.Dict(self.observation_spaces)
        self.action_space = gymnasium.spaces.Dict(self.action_spaces)

    def reset(self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
              ) -> Tuple[Dict[str, Any], Dict[str, Any]]:
        seen, infos = self.env.reset(seed=seed, options=options)
        self.agents = list(self.env.agents)
        return seen, infos

    def step(self, action_dict: Dict[str, Any]) -> Tuple[Dict[str, Any], ...]:
        seen, rewards, terminated, truncated, infos = self.env.step(action_dict)
        self.agents = list(self.env.agents)
        over = not self.agents
        cut = over and any(truncated.values())
        return (seen, rewards, {**terminated, "__all__": over and not cut},
                {**truncated, "__all__": cut}, infos)

    def render(self) -> Any:
        return self.env.render()

    def close(self) -> None:
        self.env.close()


class MaskedModule(DefaultPPOTorchRLModule):  # type: ignore[misc,unused-ignore]
    """PPO's default network for environments with mask="observation" and ids alone: it sees the
    features, and ids without an effect have no chance."""

    def __init__(self, *, observation_space: Any = None, **named: Any) -> None:
        spaces = getattr(observation_space, "spaces", {})
        if "action_mask" not in spaces:
            raise ConfigError("MaskedModule: needs mask=\"observation\" and actions that are ids, "
                              f"not {observation_space!r:.80}")
        super().__init__(observation_space=spaces["observation"], **named)

    def _forward(self, batch: Dict[str, Any], **named: Any) -> Dict[str, Any]:
        return self._masked(batch, super()._forward(_features(batch), **named))

    def _forward_train(self, batch: Dict[str, Any], **named: Any) -> Dict[str, Any]:
        return self._masked(batch, super()._forward_train(_features(batch), **named))

    def _masked(self, batch: Dict[str, Any], result: Dict[str, Any]) -> Dict[str, Any]:
        mask = batch[Columns.OBS]["action_mask"]
        # After the end no id has an effect; then any may be chosen.
        allowed = (mask != 0) | ~(mask != 0).any(-1, keepdim=True)
        logits = result[Columns.ACTION_DIST_INPUTS]
        result[Columns.ACTION_DIST_INPUTS] = logits.masked_fill(~allowed, FLOAT_MIN)
        return result

    def compute_values(self, batch: Dict[str, Any], embeddings: Any = None) -> Any:
        return super().compute_values(_features(batch), embeddings)


def _features(batch: Dict[str, Any]) -> Dict[str, Any]:
    """The batch as the network without a mask takes it."""
    seen = batch[Columns.OBS]
    return {**batch, Columns.OBS: seen["observation"]} if isinstance(seen, dict) else batch
