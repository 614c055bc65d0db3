"""A world in the form of SMAC's StarCraft2Env, as PyMARL and EPyMARL take environments."""
from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from cls_gym._config import ConfigError
from cls_gym.adapters._common import refuse_tuples
from cls_gym.env import Env


class SmacEnv:
    """A task for agents that share a reward: the mean over the agents.

    Keywords are those of Env and `seed`. Actions are ids. An agent that was sent off has one
    available action, id 0, which is not played. step() gives observations, reward, terminated,
    truncated and info as EPyMARL does; smac=True gives reward, terminated, info as SMAC and PyMARL
    do, where a truncated episode is terminated with info["episode_limit"].
    """

    def __init__(self, task: str = "cls/HFO-2v1-v0", *, seed: Optional[int] = None,
                 smac: bool = False, common_reward: bool = True,
                 reward_scalarisation: str = "mean", **config: Any) -> None:
        if not common_reward or reward_scalarisation != "mean":
            raise ConfigError("common_reward: SMAC's interface has one reward for all, the mean "
                              "over the agents; use the PettingZoo environment for others")
        self.env = Env(task, **config)
        spec = self.env.spec_of_task
        refuse_tuples(spec, "SMAC's interface")
        if not spec.actions.names:
            raise ConfigError(f"actions: SMAC's interface needs ids, which {spec.actions.name!r} "
                              "has not; did you mean 'low_discrete'?")
        if self.env._worlds.mask_place != "info":
            raise ConfigError("mask: SMAC's interface has get_avail_actions(); use \"info\"")
        self.n_agents = self.env.num_agents
        self.n_actions = len(spec.actions.names)
        self.episode_limit = -(-spec.document["max_cycles"] // spec.document["frame_skip"])
        self._smac = smac
        self._seed = seed
        self._won, self._episodes = 0, 0
        self._seen = np.zeros((self.n_agents, len(spec.features)), np.float32)

    def reset(self, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None) -> Any:
        """Observations and infos, or with smac=True observations and state."""
        first, self._seed = (self._seed if seed is None else seed), None
        seen, info = self.env.reset(seed=first, options=options)
        self._keep(seen)
        return (self.get_obs(), self.get_state()) if self._smac else (self.get_obs(), info)

    def _keep(self, seen: np.ndarray) -> None:
        self._seen = seen.reshape(self.n_agents, -1)

    def step(self, actions: Any) -> Tuple[Any, ...]:
        ids = np.asarray(actions, np.int64).reshape(self.n_agents)
        seen, reward, terminated, truncated, info = self.env.step(
            ids if self.n_agents > 1 else ids[0])
        self._keep(seen)
        over = terminated or truncated
        won = over and self.env.spec_of_task.statuses[info["status"]] in ("GOAL", "REACHED")
        self._episodes += over
        self._won += won
        extra: Dict[str, Any] = {"battle_won": bool(won)} if over else {}
        if truncated and not terminated:
            extra["episode_limit"] = True
        if self._smac:
            return reward, over, extra
        return self.get_obs(), reward, terminated, truncated, extra

    def get_obs(self) -> List[np.ndarray]:
        return list(self._seen)

    def get_obs_agent(self, agent_id: int) -> np.ndarray:
        return np.array(self._seen[agent_id])

    def get_obs_size(self) -> int:
        return self._seen.shape[1]

    def get_state(self) -> np.ndarray:
        return self.env.state()

    def get_state_size(self) -> int:
        return len(self.env.spec_of_task.state_features)

    def get_avail_actions(self) -> List[List[int]]:
        """1 where an id has an effect now, for each agent."""
        legal = self.env.action_masks().reshape(self.n_agents, self.n_actions).astype(int)
        legal[~legal.any(axis=1), 0] = 1
        return legal.tolist()

    def get_avail_agent_actions(self, agent_id: int) -> List[int]:
        return self.get_avail_actions()[agent_id]

    def get_total_actions(self) -> int:
        return self.n_actions

    def get_env_info(self) -> Dict[str, int]:
        return {"state_shape": self.get_state_size(), "obs_shape": self.get_obs_size(),
                "n_actions": self.n_actions, "n_agents": self.n_agents,
                "episode_limit": self.episode_limit}

    def get_stats(self) -> Dict[str, float]:
        rate = self._won / self._episodes if self._episodes else 0.0
        return {"battles_won": self._won, "battles_game": self._episodes, "win_rate": rate}

    def seed(self, seed: Optional[int] = None) -> None:
        """The next reset starts with this seed."""
        self._seed = seed

    def render(self) -> Any:
        return self.env.render()

    def save_replay(self) -> None:
        """SMAC's writes the episode so far; here env.record(PATH) before an episode does."""
        raise NotImplementedError("save_replay: call env.record(PATH) before reset()")

    def close(self) -> None:
        self.env.close()
