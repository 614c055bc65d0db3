"""What single and vector environments share: a pool of worlds, its spaces, actions and infos."""
from __future__ import annotations

import functools
import threading
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, TypeVar, cast

import numpy as np

from cls_gym import rendering
from cls_gym._api import ClosedEnvironmentError, ResetNeeded, warn
from cls_gym._config import (MASKS, ActionError, ConfigError, EngineError, check_choice,
                             check_keywords, with_features)
from cls_gym._engine import Pool, World, catalog, fingerprint
from cls_gym._history import Episode, History, Snapshot, replay
from cls_gym.spec import bounds
from cls_gym.tasks import resolve

Info = Dict[str, Any]
Method = TypeVar("Method", bound=Callable[..., Any])
METADATA = {"render_modes": ["human", "rgb_array", "ansi"], "render_fps": 10}


def alone(method: Method) -> Method:
    """A method of an environment that one thread at a time may call: while it runs, another thread
    gets an EngineError, and nothing has changed."""
    @functools.wraps(method)
    def guarded(self: Any, *arguments: Any, **named: Any) -> Any:
        in_use = self._worlds.in_use
        if not in_use.acquire(False):
            raise EngineError(f"{method.__name__}: another thread uses the environment; call it "
                              "from one thread at a time")
        try:
            return method(self, *arguments, **named)
        finally:
            in_use.release()
    return cast(Method, guarded)


class Worlds:
    """N worlds of one task. Arrays are the buffers of the pool: copy what you return.

    Pickle and deepcopy give the same worlds in any process: the running episodes are played again
    there, from their seeds and actions. A recording stays behind.
    """

    def __init__(self, task: str, num_envs: int, config: Dict[str, Any], *, mask: str = "info",
                 autoreset: str = "disabled", owner: str = "Worlds", own: Sequence[str] = ()
                 ) -> None:
        check_keywords(owner, config, ("task", "mask", *own))
        check_choice("mask", mask, MASKS)
        name, settings = resolve(task)
        [entry] = [one for one in catalog()["tasks"] if one["id"] == name]
        settings.update(with_features(config, entry, catalog()["feature_sets"]))
        self.task = task
        self.num_envs = num_envs
        self._arguments = (task, num_envs, dict(config), mask, autoreset)
        self.pool = self._create({**settings, "task": name, "num_envs": num_envs,
                                  "autoreset": autoreset})
        self.spec = self.pool.spec
        kinds = self.spec.actions
        if mask != "info" and not kinds.names:
            raise ConfigError(f"mask: {mask!r} needs ids, which actions={kinds.name!r} has not; "
                              "did you mean 'info'?")
        self.history = History(self.pool)
        self.recording = np.zeros(num_envs, np.bool_)
        self.in_use = threading.RLock()  # held by alone()
        self.agents = len(self.spec.agents)
        self.action_space = kinds.space(self.agents)
        self._started = np.zeros(num_envs, np.bool_)
        self._all_started = False
        self._scaled = bool(kinds.names and kinds.values)
        #: What the ids' mask is called: "action_mask" is what action_space.sample() takes.
        self.mask_name = "id_mask" if self._scaled else "action_mask"
        self.mask_place = mask if kinds.names else None
        self._unmasked = (None,) * sum(bool(own) for own in kinds.parameters)
        self.observation_space = self.spec.observation_space(self.agents, mask)
        self._view()
        if self._scaled:
            low, high = bounds(kinds.values)
            self._half_range = (high - low) / 2
            self._middle = low + self._half_range
        everywhere = np.ones(num_envs, np.bool_)
        self._set_everywhere = {"_" + key: everywhere for key, _ in self.columns}

    def _create(self, config: Dict[str, Any]) -> Pool:
        try:
            return Pool(config)
        except ConfigError as error:
            if "1..0" not in str(error):  # no player of a team that should have agents
                raise
            raise ConfigError(f"agents: {config.get('agents')!r} needs players of the defense, "
                              f"which {self.task} has not as it is; did you mean 'offense'?"
                              ) from None

    def _view(self) -> None:
        """Takes the arrays of the pool."""
        pool = self.pool
        # float32[N, F] or float32[N, A, F]
        self.observations = self._per_agent(pool.observations)
        self._own_rewards: np.ndarray = pool.rewards[:, 0]
        if pool.final_observations is not None:
            self.final_observations = self._per_agent(pool.final_observations)
        self.masks = self._per_agent(pool.action_masks) if self.spec.actions.names else None
        self.columns: List[Tuple[str, np.ndarray]] = [
            ("status", pool.status), ("cycles", pool.cycles), ("score", pool.score),
            ("illegal", self._per_agent(pool.illegal)), ("seed", pool.seeds),
            ("reward_terms", pool.reward_terms), ("opponent", pool.opponent)]
        if pool.expert.size:
            self.columns.append(("expert", self._per_agent(pool.expert)))
        self._masks_in_infos = self.mask_place == "info"
        if self._masks_in_infos and self.masks is not None:
            self.columns.append((self.mask_name, self.masks))
        self._targets = self._action_targets()

    def show_in(self, observations: np.ndarray) -> None:
        """Observations are in another array from the next step on."""
        self.pool.bind(observations=observations)
        self.observations = self._per_agent(self.pool.observations)

    def bind(self, arrays: Dict[str, Any]) -> None:
        """Replaces arrays of the pool."""
        self.pool.bind(**arrays)
        self._view()

    def _per_agent(self, array: np.ndarray) -> np.ndarray:
        """[N, A, ...], or [N, ...] of the only agent."""
        return array[:, 0] if self.agents == 1 else array

    # ---- actions

    def set_actions(self, actions: Any) -> None:
        """Takes the actions of all worlds, in the batched form of the action space."""
        if not self._scaled:
            self._take(self._targets[0], actions)
            return
        if not isinstance(actions, (tuple, list)) or len(actions) != len(self._targets):
            raise ActionError(f"action: a tuple of {len(self._targets)} arrays, not "
                              f"{actions!r:.60}")
        for target, part in zip(self._targets, actions):
            self._take(target, part)
        # From -1..1 to the units of the engine.
        values = self.pool.action_values
        values *= self._half_range
        values += self._middle

    def _take(self, target: Tuple[str, np.ndarray, str], value: Any) -> None:
        name, into, kinds = target
        if value.__class__ is not np.ndarray:
            value = np.asarray(value)
        if value.shape != into.shape:
            of = slice(1 if self.num_envs == 1 else 0, None)
            raise ActionError(f"{name}: shape {value.shape[of]}, must be {into.shape[of]}")
        if value.dtype.kind not in kinds:
            must = "integers" if into.dtype.kind == "i" else "numbers"
            raise ActionError(f"{name}: type {value.dtype}, must be {must}")
        into[...] = value
        # A number that does not fit would otherwise be played as another one.
        if into.dtype.kind == "i" and value.dtype != into.dtype \
                and np.count_nonzero(into == value) != into.size:
            wrong = value[into != value].flat[0]
            raise ActionError(f"{name}: there is no action {wrong}")

    def _action_targets(self) -> List[Tuple[str, np.ndarray, str]]:
        """What an action consists of: name, where it goes, which kinds of numbers it may have."""
        kinds, values = self.spec.actions, self._per_agent(self.pool.action_values)
        if not kinds.names:
            return [("action", values, "iuf")]
        ids = self._per_agent(self.pool.action_ids)
        if not kinds.values:
            return [("action", ids, "iu")]
        targets, start = [("action[0]", ids, "iu")], 0
        for size in (len(own) for own in kinds.parameters if own):
            targets.append((f"action[{len(targets)}]", values[..., start:start + size], "iuf"))
            start += size
        return targets

    # ---- episodes

    def reset(self, which: Optional[np.ndarray], seeds: np.ndarray,
              options: Optional[Dict[str, Any]]) -> None:
        """Starts episodes: in all worlds, or where `which` (bool[N]) is true."""
        self.check_open()
        if not isinstance(options, (dict, type(None))):
            raise TypeError(f"reset: options: a dictionary, not {options!r:.60}")
        known = {}
        for key, value in (options or {}).items():
            if key in self.spec.options:
                known[key] = value
            else:
                names = ", ".join(self.spec.options) or "none"
                warn(f"reset: option {key!r} is unknown and has no effect; options of {self.task}: "
                     f"{names}")
        if known:
            self.pool.set_options(known)
            self.history.set_options(known)
        try:
            self.pool.reset(which, seeds)
        except OSError:  # a recording could not be written: the reset is complete otherwise
            self._begun(which)
            raise
        self._begun(which)

    def _begun(self, which: Optional[np.ndarray]) -> None:
        self.history.begin(which)
        self._started[slice(None) if which is None else which] = True
        self._all_started = bool(self._started.all())

    def step(self) -> bool:
        """Plays a step in all worlds whose episode has not ended. Returns whether one began."""
        if self.pool.closed:
            self.check_open()
        if not self._all_started:
            raise ResetNeeded("step: call reset() first")
        try:
            self.pool.step()
        except OSError:  # a recording could not be written: the step is complete otherwise
            self._note()
            raise
        return self._note()

    def _note(self) -> bool:
        self.history.append()
        was_reset = self.pool.was_reset
        if not np.count_nonzero(was_reset):
            return False
        self.history.begin(was_reset)
        return True

    def rewards(self) -> np.ndarray:
        """float64[N]: the mean over the agents."""
        if self.agents == 1:
            return self._own_rewards.astype(np.float64)
        # As mean() does, without what it does around it.
        sums: np.ndarray = np.add.reduce(self.pool.rewards, axis=1, dtype=np.float64)
        return sums / self.agents

    def info(self, index: int, ended: bool = False) -> Info:
        """What Env.step() returns beside the observation, of one world."""
        info = {key: column[index].copy() for key, column in self.columns}
        if self._masks_in_infos:
            if ended:
                info[self.mask_name][...] = 0
            if self._scaled:
                info["action_mask"] = (info["id_mask"], *self._unmasked)
        return info

    def mask_info(self, mask: np.ndarray) -> Info:
        """What an info has of a mask of ids."""
        if not self._masks_in_infos:
            return {}
        mask = mask.copy()
        return {"action_mask": mask} if not self._scaled else {
            "id_mask": mask, "action_mask": (mask, *self._unmasked)}

    def infos(self, ended: Optional[np.ndarray] = None) -> Info:
        """The same of all worlds: an array per key (not the tuples `action_mask`), `_key`: where it
        was set. `ended`: bool[N], which have ended and have no mask; None: none has."""
        infos: Info = self._set_everywhere.copy()
        for key, column in self.columns:
            infos[key] = column.copy()
        if ended is not None and self._masks_in_infos:
            infos[self.mask_name][ended] = 0
        return infos

    def observe(self, which: Any = slice(None), ended: Any = None, final: bool = False) -> Any:
        """Observations of worlds (an index or a slice), with their masks where `mask` says so.
        `ended`: those (of the result) that have no mask; final: those before a reset."""
        rows = (self.final_observations if final else self.observations)[which]
        if self.mask_place in (None, "info"):
            return rows.copy()
        assert self.masks is not None
        masks = self.masks[which].copy()
        if ended is not None:
            masks[ended] = 0
        if self.mask_place == "appended":
            return np.concatenate([rows, masks], axis=-1, dtype=np.float32)
        return {"observation": rows.copy(), self.mask_name: masks}

    def legal(self, index: int) -> np.ndarray:
        """bool[K] or bool[A K]: which ids have an effect now; all where the episode is over. With
        senses each agent's K are followed by those of all their items."""
        if self.masks is None:
            raise ActionError(f"action_masks: actions={self.spec.actions.name!r} has no ids")
        if self.pool.terminated[index] or self.pool.truncated[index]:
            if self.pool.config["autoreset"] != "same_step":
                return self._flat(np.ones(self.masks[index].shape, np.bool_))
        return self._flat(self.masks[index] != 0)

    def _flat(self, mask: np.ndarray) -> np.ndarray:
        items = sum(len(sense.items) for sense in self.spec.actions.senses)
        free = np.ones((*mask.shape[:-1], items), np.bool_)
        return np.concatenate([mask, free], axis=-1).ravel()

    # ---- worlds as values

    def check_begun(self, index: int, call: str) -> None:
        self.check_open()
        if not self._started[index]:
            raise ResetNeeded(f"{call}: call reset() first")

    def snapshot(self, index: int) -> Snapshot:
        self.check_begun(index, "snapshot")
        return Snapshot(self.pool, self.history, index)

    def restore(self, index: int, snapshot: Snapshot) -> None:
        self.check_open()
        if not isinstance(snapshot, Snapshot):
            raise TypeError(f"restore: a Snapshot, not {snapshot!r:.60}")
        self.pool.view(index)  # refuses an index that is none
        if not snapshot.is_of(self.pool) and self.recording.any():
            raise EngineError("restore: a snapshot of another environment plays its episode again, "
                              "which would be recorded; record(None) first")
        snapshot.restore(self.pool, self.history, index, np.flatnonzero(self._started).tolist())
        self._started[index] = True
        self._all_started = bool(self._started.all())

    def fork(self, source: int, target: int) -> None:
        """Copies the episode of one world into another one."""
        self.check_begun(source, "fork")
        self.pool.fork(source, target)
        self.history.adopt(target, self.history.moment(source))
        self._started[target] = True
        self._all_started = bool(self._started.all())

    def view(self, index: int) -> World:
        """The physical state of a world."""
        self.check_begun(index, "view")
        return self.pool.view(index)

    def set_state(self, index: int, world: World) -> None:
        """Starts an episode of a world from a physical state."""
        self.check_open()
        if not isinstance(world, World):
            raise TypeError(f"set_state: a World, as view() returns, not {world!r:.60}")
        self.pool.set_state(index, world)
        self.history.begin_at(index, bytes(world))
        self._started[index] = True
        self._all_started = bool(self._started.all())

    def __reduce__(self) -> Any:
        if not self.in_use.acquire(False):
            raise EngineError("pickle: another thread uses the environment; copy it from one "
                              "thread at a time")
        try:
            episodes: Dict[int, Episode] = {}
            if not self.pool.closed:
                self.pool.view(0)  # refuses a pool of another process
                for index in np.flatnonzero(self._started).tolist():
                    episodes[index] = self.history.moment(index).episode()
            return _again, (type(self), self._arguments, self.history.options, fingerprint(),
                            {index: one._asdict() for index, one in episodes.items()},
                            self.pool.closed)
        finally:
            self.in_use.release()

    def play_again(self, options: Dict[str, float], engine: str,
                   episodes: Dict[int, Episode]) -> None:
        """Plays the episodes of other worlds in these. Raises EngineError if they differ here."""
        self.history.options = options
        self.pool.set_options(options)
        if episodes:
            replay(self.pool, episodes, options, engine)
        for index, episode in episodes.items():
            self.history.adopt(index, self.history.received(episode))
            self._started[index] = True
        self._all_started = bool(self._started.all())

    def record(self, index: int, path: Optional[str]) -> None:
        self.check_open()
        self.pool.record(index, path)
        self.recording[index] = path is not None

    # ---- images

    def frame(self, index: int) -> rendering.Frame:
        """What a render of a world shows."""
        self.check_open()
        world = self.pool.view(index)
        players = []
        for one in world.players:
            if one.on_pitch:
                side = "left" if one.side > 0 else "right"
                players.append(rendering.Player(side, one.unum, one.x, one.y, one.body,
                                                bool(one.goalie),
                                                f"{side}_{one.unum}" in self.spec.agents))
        status = self.spec.statuses[world.status].replace("_", " ").lower()
        title = (f"{self.spec.task}  cycle {world.cycle}  {world.score[0]}:{world.score[1]}  "
                 f"{status}")
        return rendering.Frame(title, (world.ball_x, world.ball_y), players,
                               self.spec.document["half"])

    def render(self, index: int, mode: Optional[str]) -> Any:
        if mode == "human":
            return rendering.show(self.frame(index))
        if mode == "ansi":
            return rendering.ansi(self.frame(index))
        if mode == "rgb_array":
            return rendering.rgb_array(self.frame(index))
        warn("render: no render_mode; pass render_mode=\"ansi\" or \"rgb_array\" to the "
             "constructor")
        return None

    def show(self, mode: Optional[str]) -> None:
        """Writes the situation of a single world to stdout if the mode is "human"."""
        if mode == "human":
            self.render(0, mode)

    # ---- end

    def check_open(self) -> None:
        if self.pool.closed:
            raise ClosedEnvironmentError("the environment is closed")

    def close(self) -> None:
        self.pool.close()


def _again(kind: Any, arguments: Tuple[Any, ...], options: Dict[str, float], engine: str,
           episodes: Dict[int, Dict[str, Any]], closed: bool) -> Worlds:
    """Worlds by value."""
    task, num_envs, config, mask, autoreset = arguments
    worlds: Worlds = kind(task, num_envs, config, mask=mask, autoreset=autoreset)
    if closed:
        worlds.close()
    else:
        worlds.play_again(options, engine,
                          {index: Episode(**one) for index, one in episodes.items()})
    return worlds


def check_render_mode(mode: Optional[str],
                      modes: Sequence[str] = ("human", "rgb_array", "ansi")) -> None:
    """Raises ValueError for an unknown mode."""
    if mode is not None and mode not in modes:
        raise ConfigError(f"render_mode: unknown {mode!r:.60}; modes: {', '.join(modes)}")
