"""What single and vector environments share: a pool of worlds, its spaces, actions and infos."""
from __future__ import annotations

import functools
import threading
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, TypeVar, cast

import numpy as np

from cls_gym import rendering
from cls_gym._api import ClosedEnvironmentError, ResetNeeded, warn
from cls_gym._engine import ActionError, EngineError, Pool, Snapshot
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
    """N worlds of one task. Arrays are the buffers of the pool: copy what you return."""

    def __init__(self, id: str, num_envs: int, config: Dict[str, Any]) -> None:
        self.id = id
        task, settings = resolve(id)
        self.config = config
        self.pool = Pool({**settings, **config, "task": task, "num_envs": num_envs})
        self.spec = self.pool.spec
        self.num_envs = num_envs
        self.in_use = threading.RLock()  # held by alone()
        self.agents = len(self.spec.agents)
        self.observation_space = self.spec.observation_space(self.agents)
        self.action_space = self.spec.actions.space(self.agents)
        self._started = np.zeros(num_envs, np.bool_)
        self._all_started = False
        pool = self.pool
        # float32[N, F] or float32[N, A, F]
        self.observations = self._per_agent(pool.observations)
        self._own_rewards = pool.rewards[:, 0]
        if pool.final_observations is not None:
            self.final_observations = self._per_agent(pool.final_observations)
        self.columns: List[Tuple[str, np.ndarray]] = [
            ("status", pool.status), ("cycles", pool.cycles), ("score", pool.score),
            ("illegal", self._per_agent(pool.illegal)), ("seed", pool.seeds),
            ("reward_terms", pool.reward_terms), ("opponent", pool.opponent)]
        self.masks = self._per_agent(pool.action_masks) if self.spec.actions.names else None
        if self.masks is not None:
            self.columns.append(("action_mask", self.masks))
        self._targets = self._action_targets()
        self._scaled = bool(self.spec.actions.names and self.spec.actions.values)
        if self._scaled:
            low, high = bounds(self.spec.actions.values)
            self._half_range = (high - low) / 2
            self._middle = low + self._half_range
        everywhere = np.ones(num_envs, np.bool_)
        self._set_everywhere = {"_" + key: everywhere for key, _ in self.columns}

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
        if into.dtype.kind == "i" and value.dtype != into.dtype and not (into == value).all():
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
        known = {}
        for key, value in (options or {}).items():
            if key in self.spec.options:
                known[key] = value
            else:
                names = ", ".join(self.spec.options) or "none"
                warn(f"reset: option {key!r} is unknown and has no effect; options of {self.id}: "
                     f"{names}")
        if known:
            self.pool.set_options(known)
        self.pool.reset(which, seeds)
        self._started[slice(None) if which is None else which] = True
        self._all_started = bool(self._started.all())

    def step(self) -> None:
        """Plays a step in all worlds whose episode has not ended."""
        self.check_open()
        if not self._all_started:
            raise ResetNeeded("step: call reset() first")
        self.pool.step()

    def rewards(self) -> np.ndarray:
        """float64[N]: the mean over the agents."""
        if self.agents == 1:
            return self._own_rewards.astype(np.float64)
        # As mean() does, without what it does around it.
        return np.add.reduce(self.pool.rewards, axis=1, dtype=np.float64) / self.agents

    def info(self, index: int, ended: bool = False) -> Info:
        """What Env.step() returns beside the observation, of one world."""
        info = {key: column[index].copy() for key, column in self.columns}
        if ended and self.masks is not None:
            info["action_mask"][...] = 0
        return info

    def infos(self) -> Info:
        """The same of all worlds, running ones: an array per key, `_key`: where it was set."""
        infos: Info = self._set_everywhere.copy()
        for key, column in self.columns:
            infos[key] = column.copy()
        return infos

    # ---- worlds as values

    def snapshot(self, index: int) -> Snapshot:
        self.check_open()
        if not self._started[index]:
            raise ResetNeeded("snapshot: call reset() first")
        return Snapshot(self.pool, index)

    def restore(self, index: int, snapshot: Snapshot) -> None:
        self.check_open()
        self.pool.restore(index, snapshot)
        self._started[index] = True
        self._all_started = bool(self._started.all())

    def record(self, index: int, path: Optional[str]) -> None:
        self.check_open()
        self.pool.record(index, path)

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


def check_render_mode(mode: Optional[str],
                      modes: Sequence[str] = ("human", "rgb_array", "ansi")) -> None:
    """Raises ValueError for an unknown mode."""
    if mode is not None and mode not in modes:
        raise ValueError(f"render_mode: unknown {mode!r}; modes: {', '.join(modes)}")
