"""N worlds as a gymnasium.vector.VectorEnv: one call of the engine per step."""
from __future__ import annotations

from typing import Any, Dict, Optional, Sequence, Tuple, Union

import numpy as np

from cls_gym import spaces
from cls_gym._api import AutoresetMode, BaseVectorEnv, ResetNeeded, mode_of
from cls_gym._engine import Snapshot
from cls_gym._worlds import METADATA, Info, Worlds, alone, check_render_mode
from cls_gym.seeding import SeedQueues, seed_list

Step = Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, Info]


class VectorEnv(BaseVectorEnv):
    """The same worlds as `num_envs` times Env, bit for bit, but at the speed of the engine.

        envs = cls_gym.VectorEnv("cls/HFO-1v0-v0", num_envs=64, threads=2, obs="full_state")
        observations, infos = envs.reset(seed=1)
        observations, rewards, terminations, truncations, infos = envs.step(actions)

    observations: float32[N, F]; with A > 1 agents float32[N, A, F]. rewards: float64[N], the mean
    over the agents. terminations, truncations: bool[N]. infos: as those of Env, an array per key,
    and bool[N] `_key`: where it was set.

    autoreset_mode: "next_step" (default: the step after the end ignores the action and starts the
    next episode; that step is not a transition), "same_step" (the last observation is in
    infos["final_obs"], its info in infos["final_info"]) or "disabled" (call
    reset(options={"reset_mask": bool[N]})).
    copy=False returns observations as a view that the next step overwrites.
    """

    metadata: Dict[str, Any] = dict(METADATA)

    def __init__(self, id: str = "cls/HFO-1v0-v0", num_envs: int = 1, *,
                 autoreset_mode: Union[str, AutoresetMode] = AutoresetMode.NEXT_STEP,
                 render_mode: Optional[str] = None, copy: bool = True, **config: Any) -> None:
        check_render_mode(render_mode, ("rgb_array", "ansi"))
        if isinstance(num_envs, bool) or not isinstance(num_envs, (int, np.integer)) \
                or num_envs < 1:
            raise ValueError(f"num_envs: an integer from 1 on, not {num_envs!r}")
        self._mode = mode_of(autoreset_mode)
        self.metadata = dict(METADATA, autoreset_mode=self._mode)
        self.render_mode = render_mode
        self.num_envs = int(num_envs)
        self._copy = copy
        self._same_step = self._mode is AutoresetMode.SAME_STEP
        self._worlds = Worlds(id, self.num_envs, dict(config, autoreset=self._mode.name.lower()))
        self.single_observation_space: spaces.Space = self._worlds.observation_space
        self.single_action_space: spaces.Space = self._worlds.action_space
        self.observation_space = spaces.batch_space(self.single_observation_space, self.num_envs)
        self.action_space = spaces.batch_space(self.single_action_space, self.num_envs)
        self._seeds = SeedQueues(self.num_envs)
        self._worlds.pool.use_seeds(self._seeds.next)
        self._opponents = self._worlds.pool.opponent.copy()  # of the running episodes
        self._ended = np.zeros(self.num_envs, np.bool_)

    @property
    def spec_of_task(self) -> Any:
        """cls_gym.spec.Spec: features, actions, reward terms with names, units, bounds."""
        return self._worlds.spec

    @alone
    def reset(self, *, seed: Union[int, Sequence[Optional[int]], None] = None,
              options: Optional[Dict[str, Any]] = None) -> Tuple[np.ndarray, Info]:
        """Starts episodes in all worlds, or in those of options["reset_mask"].

        seed: S seeds world i with S + i; a list has a seed (or None) for each world. Other options,
        by the names in `spec_of_task.options`, hold until changed.
        """
        worlds = self._worlds
        worlds.check_open()
        options = dict(options or {})
        which = self._reset_mask(options.pop("reset_mask", None))
        seeds = seed_list(seed, self.num_envs)
        for index in range(self.num_envs) if which is None else np.flatnonzero(which):
            if seeds[index] is not None:
                self._seeds.start(int(index), seeds[index])
        worlds.reset(which, self._seeds.next, options)
        self._seeds.take(which)
        self._opponents = worlds.pool.opponent.copy()
        self._ended[slice(None) if which is None else which] = False
        infos = worlds.infos()
        return self._observations(), infos if which is None else _only(infos, which)

    @alone
    def step(self, actions: Any) -> Step:
        """Plays one step in every world."""
        worlds, pool = self._worlds, self._worlds.pool
        worlds.check_open()
        if self._mode is AutoresetMode.DISABLED and np.count_nonzero(self._ended):
            raise ResetNeeded("step: episodes have ended in environments "
                              f"{np.flatnonzero(self._ended).tolist()}; reset(options="
                              "{'reset_mask': bool[N]}) first")
        worlds.set_actions(actions)
        worlds.step()
        terminations, truncations = pool.terminated.copy(), pool.truncated.copy()
        infos = worlds.infos()
        self._ended = ended = terminations | truncations
        if np.count_nonzero(ended):
            if self._same_step:
                infos.update(self._final(infos))
            elif worlds.masks is not None:
                infos["action_mask"][ended] = 0
        if np.count_nonzero(pool.was_reset):
            self._seeds.take(pool.was_reset)
            self._opponents = pool.opponent.copy()
        return self._observations(), worlds.rewards(), terminations, truncations, infos

    @property
    def agent_rewards(self) -> np.ndarray:
        """float32[N, A]: the rewards of the last step by agent."""
        return self._worlds.pool.rewards.copy()

    def state(self) -> np.ndarray:
        """float32[N, S]: the full states; `spec_of_task.state_features` names the numbers."""
        self._worlds.check_open()
        return self._worlds.pool.state.copy()

    def render(self) -> Optional[Tuple[Any, ...]]:
        """An image of each world: str for "ansi", uint8[height, width, 3] for "rgb_array"."""
        if self.render_mode is None:
            self._worlds.render(0, None)
            return None
        return tuple(self._worlds.render(i, self.render_mode) for i in range(self.num_envs))

    def snapshot(self, index: int) -> Snapshot:
        """The whole episode of world `index` as a value."""
        return self._worlds.snapshot(index)

    @alone
    def restore(self, index: int, snapshot: Snapshot) -> np.ndarray:
        """World `index` continues where the snapshot was taken; returns its observation."""
        self._worlds.restore(index, snapshot)
        self._settle(index)
        return self._worlds.observations[index].copy()

    @alone
    def fork(self, index: int, into: Sequence[int]) -> None:
        """Puts other worlds into the situation of world `index`."""
        for other in into:
            self._worlds.pool.fork(index, other)
            self._settle(other)

    def record(self, index: int, path: Optional[str]) -> None:
        """Writes the next episode of a world as a game log (rcg) and its commands as a text log
        (rcl); None: not."""
        self._worlds.record(index, path)

    def __enter__(self) -> "VectorEnv":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def close_extras(self, **kwargs: Any) -> None:
        """Frees the worlds; close() may be called again."""
        self._worlds.close()

    def _settle(self, index: int) -> None:
        """Notes what a world has received: whether its episode is over, seed and opponents."""
        pool = self._worlds.pool
        self._ended[index] = bool(pool.terminated[index] or pool.truncated[index])
        self._seeds.current[index] = pool.seeds[index]
        self._opponents[index] = pool.opponent[index]

    def _observations(self) -> np.ndarray:
        rows = self._worlds.observations
        return rows.copy() if self._copy else rows

    def _final(self, infos: Info) -> Info:
        """final_obs and final_info of the worlds whose episodes have ended. `infos` has what they
        ended with, and becomes what the next episodes begin with."""
        ended = self._ended
        final = np.empty(self.num_envs, dtype=object)
        for index in ended.nonzero()[0]:
            final[index] = self._worlds.final_observations[index].copy()
        last = _only(infos, ended)
        last["seed"][ended] = self._seeds.current[ended]
        last["opponent"][ended] = self._opponents[ended]
        if "action_mask" in last:
            last["action_mask"][ended] = 0
        for key in ("status", "cycles", "score", "illegal", "reward_terms"):
            infos[key][ended] = 0
        everywhere = ended.copy()
        return {"final_obs": final, "_final_obs": everywhere, "final_info": last,
                "_final_info": everywhere}

    def _reset_mask(self, mask: Any) -> Optional[np.ndarray]:
        if mask is None:
            return None
        if not isinstance(mask, np.ndarray) or mask.dtype != np.bool_ \
                or mask.shape != (self.num_envs,):
            raise TypeError(f"options[\"reset_mask\"]: an array bool[{self.num_envs}], "
                            f"not {mask!r:.60}")
        if not mask.any():
            raise ValueError("options[\"reset_mask\"]: selects no environment")
        return mask.copy()


def _only(infos: Info, which: np.ndarray) -> Info:
    """The infos of some worlds (bool[N]); zeros for the others."""
    chosen: Info = {}
    rows = which.nonzero()[0]
    for key, value in infos.items():
        if not key.startswith("_"):
            chosen[key] = some = np.zeros(value.shape, value.dtype)
            some[rows] = value[rows]
            chosen["_" + key] = which
    return chosen
