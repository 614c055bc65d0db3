"""One world as a PettingZoo ParallelEnv: each agent by its name."""
from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

import numpy as np

try:
    from pettingzoo import (  # type: ignore[import-not-found,import-untyped,unused-ignore]
        ParallelEnv as _Base)
except ImportError as error:
    raise ImportError("cls_gym.ParallelEnv needs PettingZoo: pip install pettingzoo") from error

from cls_gym import spaces
from cls_gym._api import ResetNeeded, check_gymnasium
from cls_gym._config import ActionError
from cls_gym._worlds import METADATA, Worlds, alone, check_render_mode
from cls_gym.seeding import episode_seed, generator

Dicts = Tuple[Dict[str, Any], Dict[str, float], Dict[str, bool], Dict[str, bool], Dict[str, Any]]


class ParallelEnv(_Base):  # type: ignore[misc]
    """A task for agents that act at the same time: "left_7", "right_1", ...

    >>> import cls_gym
    >>> env = cls_gym.ParallelEnv("cls/HFO-2v2-v0", agents="both", actions="low_discrete")
    >>> observations, infos = env.reset(seed=1)
    >>> env.agents
    ['left_11', 'left_7', 'right_1', 'right_2']
    >>> observations, rewards, terminations, truncations, infos = env.step(
    ...     {agent: env.action_space(agent).sample(infos[agent]["action_mask"])
    ...      for agent in env.agents})
    >>> observations["left_7"].shape
    (61,)

    observation: float32[F]. info["action_mask"]: what action_space(agent).sample() takes, where the
    action set has ids; `mask` "observation" or "appended" as in Env. state(): float32[S]. `agents`
    is empty when the episode is over; a red card ends it for one agent alone. Copies and faults are
    those of Env.
    """

    metadata: Dict[str, Any] = dict(METADATA, name="cls_v0", is_parallelizable=True)

    def __init__(self, task: str = "cls/HFO-2v1-v0", *, render_mode: Optional[str] = None,
                 mask: str = "info", **config: Any) -> None:
        check_gymnasium("ParallelEnv")
        check_render_mode(render_mode)
        self.render_mode = render_mode
        self._worlds = Worlds(task, 1, config, mask=mask, owner="ParallelEnv",
                              own=("render_mode",))
        spec = self._worlds.spec
        self.metadata = dict(self.metadata, name=task)
        self.possible_agents: List[str] = list(spec.agents)
        self.agents: List[str] = []
        self._place = {agent: place for place, agent in enumerate(spec.agents)}
        self._random: Optional[np.random.Generator] = None
        self._observation_spaces = {agent: spec.observation_space(1, mask) for agent in spec.agents}
        self._action_spaces = {agent: spec.actions.space(1) for agent in spec.agents}
        self.state_space = spec.state_space()

    @property
    def spec_of_task(self) -> Any:
        """cls_gym.spec.Spec: features, actions, reward terms with names, units, bounds."""
        return self._worlds.spec

    def observation_space(self, agent: str) -> spaces.Space[Any]:
        return self._observation_spaces[agent]

    def action_space(self, agent: str) -> spaces.Space[Any]:
        return self._action_spaces[agent]

    @alone
    def reset(self, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
              ) -> Tuple[Dict[str, Any], Dict[str, Any]]:
        """Starts an episode. `options`, by the names in the task's list, hold until changed."""
        if seed is not None or self._random is None:
            self._random = generator(seed)
        self._worlds.reset(None, np.array([episode_seed(self._random)], np.uint64), options)
        self.agents = list(self.possible_agents)
        self._worlds.show(self.render_mode)
        return self._observe(self.agents), self._infos(self.agents)

    @alone
    def step(self, actions: Dict[str, Any]) -> Dicts:
        """Plays one step; `actions` has one for each of `agents`."""
        self._worlds.check_open()
        if not self.agents:
            raise ResetNeeded("step: call reset() first")
        self._set_actions(actions)
        self._worlds.step()
        self._worlds.show(self.render_mode)
        pool, acting = self._worlds.pool, self.agents
        over = bool(pool.terminated[0]), bool(pool.truncated[0])
        alive = {agent: bool(pool.alive[0, self._place[agent]]) for agent in acting}
        self.agents = [] if any(over) else [agent for agent in acting if alive[agent]]
        return (self._observe(acting),
                {agent: float(pool.rewards[0, self._place[agent]]) for agent in acting},
                {agent: over[0] or not alive[agent] for agent in acting},
                {agent: over[1] for agent in acting}, self._infos(acting))

    def _set_actions(self, actions: Dict[str, Any]) -> None:
        missing = [agent for agent in self.agents if agent not in actions]
        if missing:
            raise ActionError(f"step: no action for {', '.join(missing)}")
        # An agent that was sent off has a row too; the engine ignores it.
        idle = actions[self.agents[0]]
        rows = [actions.get(agent, idle) for agent in self.possible_agents]
        if len(rows) == 1:
            batch: Any = _batch_of_one(rows[0])
        elif isinstance(rows[0], tuple):
            batch = tuple(np.stack(part)[None] for part in zip(*rows))
        else:
            batch = np.stack(rows)[None]
        self._worlds.set_actions(batch)

    def _observe(self, agents: List[str]) -> Dict[str, Any]:
        worlds = self._worlds
        if worlds.agents == 1:
            return {agent: worlds.observe(0) for agent in agents}
        return {agent: worlds.observe((0, self._place[agent])) for agent in agents}

    def _infos(self, agents: List[str]) -> Dict[str, Any]:
        pool = self._worlds.pool
        infos: Dict[str, Any] = {}
        for agent in agents:
            place = self._place[agent]
            infos[agent] = {"status": int(pool.status[0]), "cycles": int(pool.cycles[0]),
                            "score": pool.score[0].copy(), "seed": int(pool.seeds[0]),
                            "illegal": int(pool.illegal[0, place])}
            infos[agent].update(self._worlds.mask_info(pool.action_masks[0, place]))
        return infos

    def state(self) -> np.ndarray:
        """float32[S]: the full state, the left team's view, for a central critic."""
        self._worlds.check_open()
        return np.array(self._worlds.pool.state[0])

    def render(self) -> Any:
        """str for "ansi", uint8[height, width, 3] for "rgb_array"; "human" writes the text to
        stdout, after each reset and step too."""
        return self._worlds.render(0, self.render_mode)

    def close(self) -> None:
        """Frees the world; may be called again."""
        self._worlds.close()


def _batch_of_one(action: Any) -> Any:
    if isinstance(action, tuple):
        return tuple(np.asarray(part)[None] for part in action)
    return np.asarray(action)[None]
