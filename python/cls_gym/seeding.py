"""Seeds of episodes, drawn from one random generator per world."""
from __future__ import annotations

from typing import Any, List, Optional, Sequence

import numpy as np

_AHEAD = 64  # seeds drawn at a time


def generator(seed: Optional[int]) -> np.random.Generator:
    """The generator that gymnasium.utils.seeding.np_random(seed) makes; None: any."""
    if seed is not None and (isinstance(seed, bool) or not isinstance(seed, (int, np.integer))
                             or seed < 0):
        raise ValueError(f"seed: an integer from 0 on or None, not {seed!r}")
    return np.random.Generator(np.random.PCG64(np.random.SeedSequence(seed)))


def episode_seed(source: np.random.Generator) -> int:
    """The seed of the next episode: one draw from an environment's generator."""
    return int(source.integers(1 << 63))


class SeedQueues:
    """The sequences that episode_seed() would return for N generators, many at a time."""

    def __init__(self, count: int) -> None:
        self._sources: List[np.random.Generator] = [generator(None) for _ in range(count)]
        self._table = np.zeros((count, _AHEAD), np.uint64)
        self._used = np.full(count, _AHEAD)
        self._all = np.arange(count)
        self.next = np.zeros(count, np.uint64)  # uint64[N]: the first unused seed of each world
        self.current = np.zeros(count, np.uint64)  # the one used last
        self._look(self._all)

    def start(self, index: int, seed: int) -> None:
        """World `index` begins the sequence of `seed`."""
        self._sources[index] = generator(seed)
        self._used[index] = _AHEAD
        self._look(self._all[index:index + 1])

    def take(self, which: Optional[np.ndarray] = None) -> None:
        """Uses up `next` of the worlds in `which` (bool[N]; None: all)."""
        chosen = self._all if which is None else which.nonzero()[0]
        self.current[chosen] = self.next[chosen]
        self._used[chosen] += 1
        self._look(chosen)

    def _look(self, chosen: np.ndarray) -> None:
        for index in chosen[self._used[chosen] == _AHEAD]:
            self._table[index] = self._sources[index].integers(1 << 63, size=_AHEAD)
            self._used[index] = 0
        self.next[chosen] = self._table[chosen, self._used[chosen]]


def seed_list(seed: Any, count: int) -> Sequence[Optional[int]]:
    """A seed for each world: S + i of an integer S; a sequence as it is."""
    if seed is None:
        return [None] * count
    if isinstance(seed, (int, np.integer)):
        return [int(seed) + i for i in range(count)]
    if len(seed) != count:
        raise ValueError(f"seed: {len(seed)} seeds for num_envs={count}")
    return list(seed)
