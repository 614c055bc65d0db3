"""One world as a gymnasium.Env."""
from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

import numpy as np

from cls_gym import spaces
from cls_gym._api import BaseEnv, ResetNeeded, check_gymnasium
from cls_gym._engine import World
from cls_gym._history import Snapshot
from cls_gym._worlds import METADATA, Info, Worlds, alone, check_render_mode
from cls_gym.seeding import episode_seed


class Env(BaseEnv):  # type: ignore[misc]
    """A task for one agent, or for several that are controlled together.

    >>> import cls_gym
    >>> env = cls_gym.Env("cls/HFO-1v0-v0", actions="low_discrete")
    >>> observation, info = env.reset(seed=1)
    >>> action = env.action_space.sample(info["action_mask"])
    >>> observation, reward, terminated, truncated, info = env.step(action)
    >>> observation.shape, observation.dtype, int(info["cycles"])
    ((59,), dtype('float32'), 1)

    observation: float32[F]; with A > 1 agents float32[A, F]. `spec_of_task.features` names its
    numbers. action: as `action_space` says; with A > 1 agents one row per agent.
    reward: float, the mean over the agents. terminated, truncated: bool.
    info: `status` (index of `statuses`), `cycles` since the start of the episode, `score` (left,
    right), `illegal` actions of the episode, `seed` of the episode, `reward_terms`
    (`spec_of_task.reward_terms` names them), `opponent` of the episode (index in
    `spec_of_task.opponents`; -1: none), with `expert="planner"` the `expert`'s choice (int32[A], or a
    number; -1: nothing to choose) and, where the action set has ids, `action_mask`: what
    action_space.sample() takes. It is int8[K] or int8[A, K], 1 where an id has an effect now, 0
    after the end; where actions are tuples it is (`id_mask`, None, ...), and `id_mask` that array,
    which action_space.sample() takes, too.

    mask: "info" (default); "observation": observations are {"observation": as above, "action_mask"
    (or "id_mask"): the array}; "appended": float32[F + K] or [A, F + K], the mask after the
    features. With the last two the info has no mask. Other keywords: docs/training.md.
    Raises KeywordError (a TypeError) for an unknown keyword, ConfigError (a ValueError) for a value
    that does not exist, and ImportError where Gymnasium is installed and too old.

    An episode is a function of task, options, seed and actions. reset(seed=S) starts the same
    sequence of episodes each time. pickle and copy.deepcopy give an environment that continues with
    the same bits in any process, by playing the running episode again.
    """

    metadata: Dict[str, Any] = dict(METADATA)

    def __init__(self, task: str = "cls/HFO-1v0-v0", *, render_mode: Optional[str] = None,
                 mask: str = "info", **config: Any) -> None:
        check_gymnasium("Env")
        check_render_mode(render_mode)
        self.render_mode = render_mode
        self._worlds = Worlds(task, 1, config, mask=mask, owner="Env", own=("render_mode",))
        self._ended = False
        self.observation_space: spaces.Space[Any] = self._worlds.observation_space
        self.action_space: spaces.Space[Any] = self._worlds.action_space

    def __enter__(self) -> "Env":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    @property
    def spec_of_task(self) -> Any:
        """cls_gym.spec.Spec: features, actions, reward terms with names, units, bounds."""
        return self._worlds.spec

    @property
    def num_agents(self) -> int:
        """A: the players whose actions the caller chooses."""
        return self._worlds.agents

    @property
    def alive(self) -> np.ndarray:
        """bool[A]: False after a red card; the agent observes zeros and does not act."""
        return np.array(self._worlds.pool.alive[0])

    @property
    def agent_terminations(self) -> np.ndarray:
        """bool[A]: `terminated` by agent: a red card ends the episode for an agent alone."""
        return np.array(self._worlds.pool.terminated[0] | ~self._worlds.pool.alive[0])

    @property
    def agent_rewards(self) -> np.ndarray:
        """float32[A]: the rewards of the last step by agent."""
        return np.array(self._worlds.pool.rewards[0])

    def action_masks(self) -> np.ndarray:
        """bool[K], with A > 1 agents bool[A K], agent by agent: which ids have an effect now; all
        after the end. Raises ActionError where the action set has no ids."""
        self._worlds.check_begun(0, "action_masks")
        return self._worlds.legal(0)

    @alone
    def reset(self, *, seed: Optional[int] = None,
              options: Optional[Dict[str, Any]] = None) -> Tuple[Any, Info]:
        """Starts an episode. `options` (names: `spec_of_task.options`) hold until changed."""
        self._worlds.check_open()
        super().reset(seed=seed)
        self._worlds.reset(None, np.array([episode_seed(self.np_random)], np.uint64), options)
        self._ended = False
        self._worlds.show(self.render_mode)
        return self._worlds.observe(0), self._worlds.info(0)

    @alone
    def step(self, action: Any) -> Tuple[Any, float, bool, bool, Info]:
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
        return (worlds.observe(0, ... if self._ended else None), float(worlds.rewards()[0]),
                terminated, truncated, worlds.info(0, self._ended))

    def state(self) -> np.ndarray:
        """float32[S]: the full state, for a central critic; `spec_of_task.state_features`."""
        self._worlds.check_open()
        return np.array(self._worlds.pool.state[0])

    def render(self) -> Any:
        """str for "ansi", uint8[height, width, 3] for "rgb_array"; "human" writes the text to
        stdout, after each reset and step too."""
        return self._worlds.render(0, self.render_mode)

    def snapshot(self) -> Snapshot:
        """The whole episode as a value: restore() of it continues with the same bits. VectorEnv
        also copies episodes between worlds: fork()."""
        return self._worlds.snapshot(0)

    @alone
    def restore(self, snapshot: Snapshot) -> Any:
        """Continues where snapshot() was taken, here or in another environment or process with the
        same task and settings; returns the observation there. Raises EngineError where those differ
        or the engine plays the episode differently."""
        self._worlds.restore(0, snapshot)
        self._ended = bool(self._worlds.pool.terminated[0] or self._worlds.pool.truncated[0])
        return self._worlds.observe(0, ... if self._ended else None)

    def view(self) -> World:
        """The physical state of the world, a copy."""
        return self._worlds.view(0)

    @alone
    def set_state(self, world: World) -> Tuple[Any, Info]:
        """Starts an episode from a physical state, as view() returns it; returns what reset() does.
        Seed, cycle, clock, score, play mode, ball and players are those of `world`. Unlike a
        snapshot it is the state of the bodies alone: random numbers begin with the seed, a set play
        begins anew, and agents with obs="world_model" know what they see in it. Raises ConfigError
        that names a member where no episode can start."""
        self._worlds.set_state(0, world)
        self._ended = False
        self._worlds.show(self.render_mode)
        return self._worlds.observe(0), self._worlds.info(0)

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
