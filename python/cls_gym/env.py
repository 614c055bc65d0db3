"""One world as a gymnasium.Env."""
from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

import numpy as np

from cls_gym import spaces
from cls_gym._api import BaseEnv, ResetNeeded
from cls_gym._engine import Snapshot
from cls_gym._worlds import METADATA, Info, Worlds, alone, check_render_mode
from cls_gym.seeding import episode_seed


class Env(BaseEnv):
    """A task for one agent, or for several that are controlled together.

        env = cls_gym.Env("cls/HFO-1v0-v0", obs="full_state")
        observation, info = env.reset(seed=1)
        observation, reward, terminated, truncated, info = env.step(env.action_space.sample())

    observation: float32[F]; with A > 1 agents float32[A, F]. `features` names its numbers.
    action: as `action_space` says; with A > 1 agents one row per agent.
    reward: float, the mean over the agents. terminated, truncated: bool.
    info: `status` (index of `statuses`), `cycles` since the start of the episode, `score` (left,
    right), `illegal` actions of the episode, `seed` of the episode, `reward_terms`
    (`spec_of_task.reward_terms` names them), `opponent` of the episode (index in
    `spec_of_task.opponents`; -1: none) and, where the action set has ids, `action_mask` (int8[K],
    or int8[A, K]: 1 where an id has an effect now; 0 after the end).

    An episode is a function of task, options, seed and actions. reset(seed=S) starts the same
    sequence of episodes each time.
    """

    metadata: Dict[str, Any] = dict(METADATA)

    def __init__(self, id: str = "cls/HFO-1v0-v0", *, render_mode: Optional[str] = None,
                 **config: Any) -> None:
        check_render_mode(render_mode)
        self.render_mode = render_mode
        self._worlds = Worlds(id, 1, config)
        self._ended = False
        self.observation_space: spaces.Space = self._worlds.observation_space
        self.action_space: spaces.Space = self._worlds.action_space

    @property
    def spec_of_task(self) -> Any:
        """cls_gym.spec.Spec: features, actions, reward terms with names, units, bounds."""
        return self._worlds.spec

    @alone
    def reset(self, *, seed: Optional[int] = None,
              options: Optional[Dict[str, Any]] = None) -> Tuple[np.ndarray, Info]:
        """Starts an episode. `options` (names: `spec_of_task.options`) hold until changed."""
        self._worlds.check_open()
        super().reset(seed=seed)
        self._worlds.reset(None, np.array([episode_seed(self.np_random)], np.uint64), options)
        self._ended = False
        self._worlds.show(self.render_mode)
        return self._worlds.observations[0].copy(), self._worlds.info(0)

    @alone
    def step(self, action: Any) -> Tuple[np.ndarray, float, bool, bool, Info]:
        """Plays one step: `frame_skip` cycles, or fewer at the end of the episode."""
        worlds = self._worlds
        worlds.check_open()
        if self._ended:
            raise ResetNeeded("step: the episode has ended; call reset()")
        worlds.set_actions(_batch_of_one(action))
        worlds.step()
        terminated, truncated = bool(worlds.pool.terminated[0]), bool(worlds.pool.truncated[0])
        self._ended = terminated or truncated
        worlds.show(self.render_mode)
        return (worlds.observations[0].copy(), float(worlds.rewards()[0]), terminated, truncated,
                worlds.info(0, self._ended))

    def state(self) -> np.ndarray:
        """float32[S]: the full state, for a central critic; `spec_of_task.state_features`."""
        self._worlds.check_open()
        return self._worlds.pool.state[0].copy()

    def render(self) -> Any:
        """str for "ansi", uint8[height, width, 3] for "rgb_array"; "human" writes the text to
        stdout, after each reset and step too."""
        return self._worlds.render(0, self.render_mode)

    def snapshot(self) -> Snapshot:
        """The whole episode as a value: restore() of it continues with the same bits. VectorEnv
        also copies episodes between worlds: fork()."""
        return self._worlds.snapshot(0)

    @alone
    def restore(self, snapshot: Snapshot) -> np.ndarray:
        """Continues where snapshot() was taken; returns the observation there."""
        self._worlds.restore(0, snapshot)
        self._ended = bool(self._worlds.pool.terminated[0] or self._worlds.pool.truncated[0])
        return self._worlds.observations[0].copy()

    def record(self, path: Optional[str]) -> None:
        """Writes the next episode, from its reset() to its end, as a game log (rcg) and its
        commands as a text log (rcl); None: not."""
        self._worlds.record(0, path)

    def close(self) -> None:
        """Frees the world; may be called again."""
        self._worlds.close()


def _batch_of_one(action: Any) -> Any:
    if isinstance(action, tuple):
        return tuple(np.asarray(part)[None] for part in action)
    return np.asarray(action)[None]
