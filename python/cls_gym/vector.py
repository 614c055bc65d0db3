"""N worlds as a gymnasium.vector.VectorEnv: one call of the engine per step."""
from __future__ import annotations

from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from cls_gym import spaces
from cls_gym._api import AutoresetMode, BaseVectorEnv, ResetNeeded, check_gymnasium, mode_of
from cls_gym._config import ConfigError
from cls_gym._engine import World
from cls_gym._history import Snapshot
from cls_gym._worlds import METADATA, Info, Worlds, alone, check_render_mode
from cls_gym.seeding import SeedQueues, seed_list

Step = Tuple[Any, np.ndarray, np.ndarray, np.ndarray, Info]


class VectorEnv(BaseVectorEnv):  # type: ignore[misc]
    """The same worlds as `num_envs` times Env, bit for bit, but at the speed of the engine.

    >>> import cls_gym
    >>> envs = cls_gym.VectorEnv("cls/HFO-1v0-v0", num_envs=64, actions="low_discrete")
    >>> observations, infos = envs.reset(seed=1)
    >>> actions = envs.action_space.sample(infos["action_mask"])
    >>> observations, rewards, terminations, truncations, infos = envs.step(actions)
    >>> observations.shape, rewards.dtype
    ((64, 59), dtype('float64'))

    observations: float32[N, F]; with A > 1 agents float32[N, A, F]. rewards: float64[N], the mean
    over the agents. terminations, truncations: bool[N]. infos: as those of Env, an array per key,
    and bool[N] `_key`: where it was set. Where actions are tuples they have `id_mask` alone, which
    envs.action_space.sample() takes, too. `mask` as in Env.

    autoreset_mode: "next_step" (default: the step after the end ignores the action and starts the
    next episode; that step is not a transition), "same_step" (the last observation is in
    infos["final_obs"], its info in infos["final_info"], the full state in infos["final_state"],
    float32[N, S]) or "disabled" (call reset(options={"reset_mask": bool[N]})).
    copy=False returns observations (not those with masks) without copying them, from two arrays in
    turn: they hold until the step after the next one.
    Copies, and errors of the constructor, are those of Env; `num_envs`, `mask` and the modes give a
    ConfigError, too.
    """

    metadata: Dict[str, Any] = dict(METADATA)

    def __init__(self, task: str = "cls/HFO-1v0-v0", num_envs: int = 1, *,
                 autoreset_mode: Union[str, AutoresetMode] = AutoresetMode.NEXT_STEP,
                 render_mode: Optional[str] = None, copy: bool = True, mask: str = "info",
                 **config: Any) -> None:
        check_gymnasium("VectorEnv")
        check_render_mode(render_mode, ("rgb_array", "ansi"))
        if isinstance(num_envs, bool) or not isinstance(num_envs, (int, np.integer)) \
                or num_envs < 1:
            raise ConfigError(f"num_envs: an integer from 1 on, not {num_envs!r:.60}")
        self.autoreset_mode = self._mode = mode_of(autoreset_mode)
        self.metadata = dict(METADATA, autoreset_mode=self._mode)
        self.render_mode = render_mode
        self.num_envs = int(num_envs)
        self._same_step = self._mode is AutoresetMode.SAME_STEP
        self._worlds = Worlds(task, self.num_envs, config, mask=mask,
                              autoreset=self._mode.name.lower(), owner="VectorEnv",
                              own=("num_envs", "autoreset_mode", "render_mode", "copy"))
        self._whole = self._worlds.mask_place not in ("observation", "appended")
        self._copy = copy or not self._whole
        self._other: Optional[np.ndarray] = None  # with copy=False: the array of the next step
        if not self._copy:
            self._other = self._worlds.pool.observations.copy()
        self.single_observation_space: spaces.Space[Any] = self._worlds.observation_space
        self.single_action_space: spaces.Space[Any] = self._worlds.action_space
        self.observation_space = spaces.batch_space(self.single_observation_space, self.num_envs)
        self.action_space = spaces.batch_space(self.single_action_space, self.num_envs)
        self._seeds = SeedQueues(self.num_envs)
        self._worlds.pool.bind(next_seeds=self._seeds.next)
        self._opponents = self._worlds.pool.opponent.copy()  # of the running episodes
        self._ended = np.zeros(self.num_envs, np.bool_)

    @property
    def spec_of_task(self) -> Any:
        """cls_gym.spec.Spec: features, actions, reward terms with names, units, bounds."""
        return self._worlds.spec

    @alone
    def reset(self, *, seed: Union[int, Sequence[Optional[int]], None] = None,
              options: Optional[Dict[str, Any]] = None) -> Tuple[Any, Info]:
        """Starts episodes in all worlds, or in those of options["reset_mask"].

        seed: S seeds world i with S + i; a list has a seed (or None) for each world. Other options,
        by the names in `spec_of_task.options`, hold until changed.
        """
        worlds = self._worlds
        worlds.check_open()
        options = dict(options or {})
        which = self._reset_mask(options.pop("reset_mask", None))
        seeds = seed_list(seed, self.num_envs)
        for index in range(self.num_envs) if which is None else np.flatnonzero(which).tolist():
            own = seeds[index]
            if own is not None:
                self._seeds.start(index, own)
        self._in_turn(lambda: worlds.reset(which, self._seeds.next, options))
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
        began = self._in_turn(worlds.step, keep=False)
        terminations, truncations = pool.terminated.copy(), pool.truncated.copy()
        self._ended = ended = terminations | truncations
        without = None
        if not np.count_nonzero(ended):
            infos = worlds.infos()
        elif self._same_step:
            infos = worlds.infos()
            infos.update(self._final(infos))
        else:
            without = ended
            infos = worlds.infos(ended)
        if began:
            self._seeds.take(pool.was_reset)
            self._opponents = pool.opponent.copy()
        return self._observations(without), worlds.rewards(), terminations, truncations, infos

    def _in_turn(self, call: Callable[[], Any], keep: bool = True) -> Any:
        """The result of a call for which the engine, with copy=False, writes into the other array.
        keep: rows that it does not write stay as they are."""
        if self._other is None:
            return call()
        if keep:
            self._other[...] = self._worlds.pool.observations
        self._turn()
        try:
            return call()
        except OSError:  # a recording could not be written: the call is complete otherwise
            raise
        except Exception:  # no world has changed
            self._turn()
            raise

    def _turn(self) -> None:
        now = self._worlds.pool.observations
        assert self._other is not None
        self._worlds.show_in(self._other)
        self._other = now

    def bind(self, **arrays: Any) -> None:
        """The engine reads and writes arrays of the caller from now on: contiguous and writable
        ones of the right type and number of elements, or what has DLPack (shared or pinned memory).

        action_ids int32[N, A], action_values float32[N, A, V] (step() fills them), observations
        float32[N, A, F], rewards float32[N, A], action_masks int8[N, A, K], state float32[N, S] and
        others of the C header. With copy=False observations are then views of the caller's array.
        Raises ConfigError for an array that does not fit.
        """
        self._worlds.check_open()
        if "next_seeds" in arrays:
            raise ConfigError("bind: next_seeds: reset(seed=...) decides; did you mean seeds?")
        if "observations" in arrays:
            self._other = None
        self._worlds.bind(arrays)

    @property
    def num_agents(self) -> int:
        """A: the players of a world whose actions the caller chooses."""
        return self._worlds.agents

    @property
    def alive(self) -> np.ndarray:
        """bool[N, A]: False after a red card; the agent observes zeros and does not act."""
        return self._worlds.pool.alive.copy()

    @property
    def agent_terminations(self) -> np.ndarray:
        """bool[N, A]: where the last step ended an episode that has no future, or a red card has
        ended it for the agent alone."""
        pool = self._worlds.pool
        return np.asarray(pool.terminated[:, None] | ~pool.alive)

    @property
    def agent_rewards(self) -> np.ndarray:
        """float32[N, A]: the rewards of the last step by agent."""
        return self._worlds.pool.rewards.copy()

    def action_masks(self) -> List[np.ndarray]:
        """Of each world bool[K], with A > 1 agents bool[A K], agent by agent: which ids have an
        effect now; all where the episode is over. Raises ActionError where the action set has no
        ids."""
        for index in range(self.num_envs):
            self._worlds.check_begun(index, "action_masks")
        return [self._worlds.legal(index) for index in range(self.num_envs)]

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
    def restore(self, index: int, snapshot: Snapshot) -> Any:
        """World `index` continues where the snapshot was taken, here or elsewhere (as Env.restore);
        returns its observation."""
        self._in_turn(lambda: self._worlds.restore(index, snapshot))
        self._settle(index)
        return self._worlds.observe(index, ... if self._ended[index] else None)

    @alone
    def fork(self, index: int, into: Sequence[int]) -> None:
        """Puts other worlds into the situation of world `index`."""
        def copy_all() -> None:
            for other in into:
                self._worlds.fork(index, other)
                self._settle(other)

        self._in_turn(copy_all)

    def view(self, index: int) -> World:
        """The physical state of world `index`, a copy."""
        return self._worlds.view(index)

    @alone
    def set_state(self, index: int, world: World) -> Any:
        """Starts an episode of world `index` from a physical state (as Env.set_state); returns its
        observation."""
        self._in_turn(lambda: self._worlds.set_state(index, world))
        self._settle(index)
        return self._worlds.observe(index)

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
        if "_worlds" in self.__dict__:  # else the constructor failed, and Gymnasium closes
            self._worlds.close()

    def _settle(self, index: int) -> None:
        """Notes what a world has received: whether its episode is over, seed and opponents."""
        pool = self._worlds.pool
        self._ended[index] = bool(pool.terminated[index] or pool.truncated[index])
        self._seeds.current[index] = pool.seeds[index]
        self._opponents[index] = pool.opponent[index]

    def _observations(self, ended: Optional[np.ndarray] = None) -> Any:
        if self._whole:
            rows = self._worlds.observations
            return rows.copy() if self._copy else rows
        return self._worlds.observe(ended=ended)

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._worlds.pool.bind(next_seeds=self._seeds.next)

    def _final(self, infos: Info) -> Info:
        """final_obs and final_info of the worlds whose episodes have ended. `infos` has what they
        ended with, and becomes what the next episodes begin with."""
        ended = self._ended
        rows = _rows(ended)
        final = np.empty(self.num_envs, dtype=object)
        for index in ended.nonzero()[0]:
            final[index] = self._worlds.observe(index, ..., final=True)
        last = _only(infos, ended, self._worlds.mask_name)
        last["seed"][rows] = self._seeds.current[rows]
        last["opponent"][rows] = self._opponents[rows]
        for key in ("status", "cycles", "score", "illegal", "reward_terms"):
            infos[key][rows] = 0
        states = self._worlds.pool.final_state
        state = np.zeros(states.shape, np.float32)
        state[rows] = states[rows]
        everywhere = ended.copy()
        return {"final_obs": final, "_final_obs": everywhere, "final_info": last,
                "_final_info": everywhere, "final_state": state, "_final_state": everywhere}

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


def _rows(which: np.ndarray) -> Any:
    """Where bool[N] is true: an index for arrays; a single integer takes a third of the time."""
    rows = which.nonzero()[0]
    return int(rows[0]) if len(rows) == 1 else rows


def _only(infos: Info, which: np.ndarray, without: str = "") -> Info:
    """The infos of some worlds (bool[N]); zeros for the others and for the key `without`."""
    chosen: Info = {}
    rows = _rows(which)
    for key, value in infos.items():
        if not key.startswith("_"):
            chosen[key] = some = np.zeros(value.shape, value.dtype)
            if key != without:
                some[rows] = value[rows]
            chosen["_" + key] = which
    return chosen
