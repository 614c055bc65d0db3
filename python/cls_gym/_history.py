"""Episodes as values: seed, options and actions so far, from which any process plays them again."""
from __future__ import annotations

import os
import weakref
import zlib
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from cls_gym._api import warn
from cls_gym._config import EngineError
from cls_gym._engine import Pool, World, fingerprint, library

Actions = Tuple[np.ndarray, np.ndarray]  # ids [T, A] (or [T, 0]), values float32[T, A, V]
#: Bytes of actions that an environment keeps; episodes that began before them cannot travel.
LIMIT = 256 << 20
_BLOCK = 4 << 20
_LOST = ("the episode is longer than what the environment remembers of its actions; it can be "
         "restored here, but not copied to another environment or process")


class Past:
    """The actions of an episode up to a moment. Copies of an episode share their beginning."""

    __slots__ = ("before", "actions")

    def __init__(self, before: Optional["Past"], actions: Optional[Actions]) -> None:
        self.before = before
        self.actions = actions  # None: forgotten


class Episode(NamedTuple):
    """An episode up to a moment. It is a function of seed, options and actions."""

    seed: int
    options: Dict[str, float]  # all of the task
    ids: np.ndarray            # [T, A]
    values: np.ndarray         # float32[T, A, V]
    mark: int                  # of what the engine showed then
    start: Optional[bytes] = None  # a World from which it started; None: where its task says

    @property
    def steps(self) -> int:
        """T: how many were played."""
        return max(len(self.ids), len(self.values))


def mark_of(pool: Pool, index: int) -> int:
    """A number that differs where a world shows another state or other observations."""
    return zlib.crc32(pool.observations[index], zlib.crc32(pool.state[index]))


class History:
    """The actions of the running episodes of a pool."""

    def __init__(self, pool: Pool) -> None:
        self._pool = pool
        count, agents = pool.rewards.shape
        ids = len(pool.spec.actions.names)
        self._kind = np.uint8 if ids <= 256 else np.int32
        self._shapes = pool.action_ids.shape, pool.action_values.shape
        row = pool.action_ids.size * np.dtype(self._kind).itemsize + pool.action_values.nbytes
        self._rows = max(16, min(1024, _BLOCK // max(row, 1)))
        self._limit = max(2, LIMIT // max(row * self._rows, 1))
        self._blocks: List[Actions] = []
        self._spare: List[Actions] = []
        self._first = 0         # number of the step of the first row of the first block
        self._free = 0          # rows that are free in the last block
        self._now = 0           # steps so far
        self._has_ids, self._has_values = bool(ids), bool(pool.action_values.size)
        self._start = np.zeros(count, np.int64)  # the step from which a world's actions are here
        self._past: List[Optional[Past]] = [None] * count  # those before
        self.options: Dict[str, float] = dict(pool.spec.document["options"])
        self._options_of = [self.options] * count  # those of the running episode
        self._start_of: List[Optional[bytes]] = [None] * count  # its state, if it was given
        self._nothing = (np.empty((0, *self._shapes[0][1:]), self._kind),
                         np.empty((0, *self._shapes[1][1:]), np.float32))

    def append(self) -> None:
        """Notes the actions of a step."""
        if not self._free:
            self._turn()
        ids, values = self._blocks[-1]
        if self._has_ids:
            ids[-self._free] = self._pool.action_ids
        if self._has_values:
            values[-self._free] = self._pool.action_values
        self._free -= 1
        self._now += 1

    def _turn(self) -> None:
        """Begins a block, and forgets those that no running episode needs, or too many."""
        oldest = int(self._start.min())
        while self._blocks and (self._first + self._rows <= oldest
                                or len(self._blocks) >= self._limit):
            self._spare = [self._blocks.pop(0)]
            self._first += self._rows
        if not self._blocks:
            self._first = self._now
        self._blocks.append(self._spare.pop() if self._spare else
                            (np.empty((self._rows, *self._shapes[0]), self._kind),
                             np.empty((self._rows, *self._shapes[1]), np.float32)))
        self._free = self._rows

    def begin(self, which: Any) -> None:
        """Worlds (bool[N]; None: all) have begun an episode where their task says."""
        rows = range(len(self._past)) if which is None else which.nonzero()[0].tolist()
        for index in rows:
            self._start[index] = self._now
            self._past[index] = None
            self._options_of[index] = self.options
            self._start_of[index] = None

    def begin_at(self, index: int, start: bytes) -> None:
        """World `index` has begun an episode in a state."""
        self._start[index], self._past[index] = self._now, None
        self._options_of[index], self._start_of[index] = self.options, start

    def set_options(self, options: Dict[str, Any]) -> None:
        """Options of the next episodes."""
        self.options = {**self.options, **{key: float(value) for key, value in options.items()}}

    def past(self, index: int) -> Optional[Past]:
        """What world `index` has played until now; None: nothing."""
        start = int(self._start[index])
        if start < self._now:
            gathered = self._gather(index, start) if start >= self._first else None
            self._past[index] = Past(self._past[index], gathered)
            self._start[index] = self._now
        return self._past[index]

    def _gather(self, index: int, start: int) -> Actions:
        parts: List[Actions] = []
        for number in range((start - self._first) // self._rows, len(self._blocks)):
            first = self._first + number * self._rows
            rows = slice(max(0, start - first), min(self._rows, self._now - first))
            ids, values = self._blocks[number]
            parts.append((ids[rows, index], values[rows, index]))
        return (np.concatenate([ids for ids, _ in parts]),
                np.concatenate([values for _, values in parts]))

    def moment(self, index: int) -> "Moment":
        """The episode of a world now."""
        return Moment(int(self._pool.seeds[index]), self._options_of[index], self.past(index),
                      mark_of(self._pool, index), self._nothing, self._start_of[index])

    def received(self, episode: Episode) -> "Moment":
        """An episode of another process as one of this."""
        past = Past(None, (episode.ids, episode.values)) if episode.steps else None
        return Moment(episode.seed, episode.options, past, episode.mark, self._nothing,
                      episode.start)

    def adopt(self, index: int, moment: "Moment") -> None:
        """World `index` continues an episode from a moment."""
        self._start[index] = self._now
        self._past[index] = moment.past
        self._options_of[index] = moment.options
        self._start_of[index] = moment.start


class Moment(NamedTuple):
    """An episode up to a moment, of this process."""

    seed: int
    options: Dict[str, float]
    past: Optional[Past]
    mark: int
    nothing: Actions  # no actions, in their shapes
    start: Optional[bytes]

    def episode(self) -> Episode:
        """The same by value. Raises EngineError where actions were forgotten."""
        parts, past = [self.nothing], self.past
        while past is not None:
            if past.actions is None:
                raise EngineError(_LOST)
            parts.insert(1, past.actions)
            past = past.before
        return Episode(self.seed, self.options, np.concatenate([ids for ids, _ in parts]),
                       np.concatenate([values for _, values in parts]), self.mark, self.start)


def replay(pool: Pool, episodes: Dict[int, Episode], options: Dict[str, float],
           engine: str) -> None:
    """Plays episodes in their worlds so that all reach their last action in the same step. Other
    worlds play anything. `options` are those of the next episodes, `engine` the fingerprint of the
    one that played them first. Raises EngineError if this one plays differently."""
    longest = max((one.steps for one in episodes.values()), default=0)
    begin: Dict[int, List[int]] = {}
    seeds = np.zeros(len(pool.seeds), np.uint64)
    for index, episode in episodes.items():
        begin.setdefault(longest - episode.steps, []).append(index)
        pool.set_options(episode.options, index)
        seeds[index] = episode.seed
    pool.reset(None, seeds)
    pool.action_ids[...] = 0
    pool.action_values[...] = 0
    running: List[int] = []
    for step in range(longest + 1):
        due = begin.get(step, [])
        if step and due:
            which = np.zeros(len(seeds), np.bool_)
            which[due] = True
            pool.reset(which, seeds)
        for index in due:
            start = episodes[index].start
            if start is not None:
                pool.set_state(index, World.from_buffer_copy(start))
        running += due
        if step == longest:
            break
        for index in running:
            episode = episodes[index]
            number = step - longest + episode.steps
            if episode.ids.size:
                pool.action_ids[index] = episode.ids[number]
            if episode.values.size:
                pool.action_values[index] = episode.values[number]
        pool.step()
    pool.set_options(options)
    _compare(pool, episodes, engine)


def _compare(pool: Pool, episodes: Dict[int, Episode], engine: str) -> None:
    same = engine == fingerprint()
    for index, episode in episodes.items():
        if episode.steps and pool.was_reset[index]:
            raise EngineError("the episode has ended; with autoreset_mode=\"same_step\" no world "
                              "stays at an end")
        if mark_of(pool, index) != episode.mark:
            raise EngineError(
                f"this engine ({fingerprint()}) plays the episode with seed {episode.seed} "
                + ("differently: the copy is damaged" if same else
                   f"differently from the one that played it first ({engine})"))
    if not same:
        warn(f"cls_gym: the episode was played by another engine ({engine}) than this one "
             f"({fingerprint()}); it is in the same state, but may continue differently")


def _setting(pool: Pool) -> Dict[str, Any]:
    """What an episode depends on beside seed, options and actions."""
    return {key: value for key, value in pool.config.items()
            if key not in ("num_envs", "threads", "autoreset", "options")}


class Snapshot:
    """An episode at one moment, as Env.snapshot() and VectorEnv.snapshot() return it.

    In the environment that it is of, it restores the engine's copy. In another one with the same
    task and settings, and after pickle in any process, it has the seed, the options and the actions
    so far, and restoring plays them again: about as long as the episode took. Immutable; the
    engine's copy is freed with the last reference.
    """

    def __init__(self, pool: Pool, history: History, index: int) -> None:
        self._setting = _setting(pool)
        self._engine: Optional[str] = None  # None: this one
        self._episode: Optional[Episode] = None
        self._moment: Optional[Moment] = history.moment(index)
        self._copies: Dict[Tuple[int, int], int] = {}
        self._keep(pool, index)

    def _keep(self, pool: Pool, index: int) -> None:
        """Takes the engine's copy of what world `index` shows."""
        handle = pool.snapshot(index)
        self._copies[os.getpid(), pool.handle] = handle
        weakref.finalize(self, library().cls_training_release, pool.handle, handle)

    def is_of(self, pool: Pool) -> bool:
        """Whether the engine has a copy for this pool."""
        return (os.getpid(), pool.handle) in self._copies

    @property
    def episode(self) -> Episode:
        """Seed, options and actions so far."""
        if self._episode is None:
            assert self._moment is not None
            self._episode = self._moment.episode()
        return self._episode

    def restore(self, pool: Pool, history: History, index: int, others: Sequence[int]) -> None:
        """Continues the episode in world `index`. `others`, worlds that have begun, stay as they
        are."""
        handle = self._copies.get((os.getpid(), pool.handle))
        if handle is None:
            self._replay(pool, history, index, others)
        else:
            pool.restore(index, handle)
        assert self._moment is not None
        history.adopt(index, self._moment)

    def _replay(self, pool: Pool, history: History, index: int, others: Sequence[int]) -> None:
        self._check_setting(pool)
        episode = self.episode
        kept = {other: pool.snapshot(other) for other in others}
        shown = {name: array.copy() for name, array in pool.outputs().items()}
        failed = True
        try:
            replay(pool, {index: episode}, history.options, self._engine or fingerprint())
            own = {name: array[index].copy() for name, array in pool.outputs().items()}
            self._keep(pool, index)
            failed = False
        finally:
            for other, handle in kept.items():
                if failed or other != index:
                    pool.restore(other, handle)
                pool.release(handle)
            for name, array in pool.outputs().items():
                array[...] = shown[name]
                if not failed:
                    array[index] = own[name]
        if self._moment is None:
            self._moment = history.received(episode)

    def _check_setting(self, pool: Pool) -> None:
        here = _setting(pool)
        for key in sorted({*here, *self._setting}):
            if here.get(key) != self._setting.get(key):
                raise EngineError(
                    "restore: the snapshot is of another environment: "
                    f"{key}={self._setting.get(key)!r}, here {here.get(key)!r}")

    def __reduce__(self) -> Any:
        return _unpickled, (self._setting, self.episode._asdict(), self._engine or fingerprint())

    def __copy__(self) -> "Snapshot":
        return self

    def __deepcopy__(self, memo: Any) -> "Snapshot":
        return self


def _unpickled(setting: Dict[str, Any], episode: Dict[str, Any], engine: str) -> Snapshot:
    snapshot = Snapshot.__new__(Snapshot)
    snapshot._setting, snapshot._engine = setting, engine
    snapshot._episode, snapshot._moment = Episode(**episode), None
    snapshot._copies = {}
    return snapshot
