"""Tasks of cls for BenchMARL's experiments."""
from __future__ import annotations

from typing import Any, Callable, Dict, List, Optional

import torch
from benchmarl.environments.common import TaskClass
from torchrl.data import Composite
from torchrl.envs import EnvBase

from cls_gym.adapters.torchrl import ClsEnv
from cls_gym.tasks import resolve
from cls_gym.vector import VectorEnv


class ClsTask(TaskClass):  # type: ignore[misc,unused-ignore]
    """A task by its id, with the keywords of VectorEnv as `config`: all agents are one group.

    >>> ClsTask("cls/HFO-2v1-v0", {"features": "ego", "actions": "skills"})  # doctest: +SKIP

    Pass it to benchmarl's Experiment as `task`. Actions are ids with masks, or, with
    actions="low_flat", numbers.
    """

    def __init__(self, name: str, config: Optional[Dict[str, Any]] = None) -> None:
        resolve(name)
        # The name becomes that of a folder.
        super().__init__(name.removeprefix("cls/"),
                         dict({"actions": "low_discrete"}, **(config or {})))

    def get_env_fun(self, num_envs: int, continuous_actions: bool, seed: Optional[int],
                    device: Any) -> Callable[[], EnvBase]:
        def make() -> EnvBase:
            env = ClsEnv(VectorEnv(self.name, num_envs, autoreset_mode="disabled", **self.config),
                         device=device)
            if seed is not None:
                env.set_seed(seed)
            return env
        return make

    def supports_continuous_actions(self) -> bool:
        return bool(self.config["actions"] == "low_flat")

    def supports_discrete_actions(self) -> bool:
        return not self.supports_continuous_actions()

    def max_steps(self, env: EnvBase) -> int:
        document = env.envs.spec_of_task.document
        return -int(-document["max_cycles"] // document["frame_skip"])

    def has_render(self, env: EnvBase) -> bool:
        return False

    def group_map(self, env: EnvBase) -> Dict[str, List[str]]:
        return {"agents": list(env.envs.spec_of_task.agents)}

    def _of_agents(self, env: EnvBase, key: str) -> Optional[Composite]:
        agents = env.full_observation_spec_unbatched["agents"]
        if key not in agents.keys():
            return None
        own = Composite({key: agents[key].clone()}, shape=agents.shape, device=env.device)
        return Composite({"agents": own}, device=env.device)

    def observation_spec(self, env: EnvBase) -> Composite:
        return self._of_agents(env, "observation")

    def action_mask_spec(self, env: EnvBase) -> Optional[Composite]:
        return self._of_agents(env, "action_mask")

    def info_spec(self, env: EnvBase) -> Optional[Composite]:
        return None

    def state_spec(self, env: EnvBase) -> Optional[Composite]:
        spec = env.full_observation_spec_unbatched["state"]
        return Composite({"state": spec.clone()}, device=env.device)

    def action_spec(self, env: EnvBase) -> Composite:
        return env.full_action_spec_unbatched

    @staticmethod
    def env_name() -> str:
        return "cls"

    @staticmethod
    def log_info(batch: Any) -> Dict[str, float]:
        """The share of goals among the episodes that ended in a batch."""
        ended = batch["next", "done"].reshape(-1)
        goals = batch["next", "status"].reshape(-1)[ended] == 1
        return {"collection/goals": goals.to(torch.float32).mean().item()} if ended.any() else {}
