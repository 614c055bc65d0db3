"""Spaces of observations and actions: Gymnasium's where it is installed, else small ones alike.

The small ones have what training loops use: `shape`, `dtype`, `n`, `low`, `high`, `sample()`,
`seed()`, `contains()`, `in`, `==`.
"""
from __future__ import annotations

from typing import Any, Dict as DictType, Iterable, List, Optional, Sequence, Tuple as TupleType

import numpy as np

try:
    from gymnasium.spaces import Box, Dict, Discrete, MultiDiscrete, Space, Tuple
    from gymnasium.vector.utils import batch_space as _batch_space

    HAVE_GYMNASIUM = True
except ImportError:
    HAVE_GYMNASIUM = False

    class Space:  # type: ignore[no-redef]
        """A set of values of one shape and type."""

        def __init__(self, shape: Optional[Sequence[int]], dtype: Any,
                     seed: Optional[int] = None) -> None:
            self.shape = None if shape is None else tuple(int(n) for n in shape)
            self.dtype = None if dtype is None else np.dtype(dtype)
            self._random = np.random.default_rng(seed)

        def seed(self, seed: Optional[int] = None) -> Any:
            """Starts the random numbers of sample() again."""
            self._random = np.random.default_rng(seed)
            return seed

        def __contains__(self, value: Any) -> bool:
            return self.contains(value)

        def contains(self, value: Any) -> bool:
            raise NotImplementedError

    class Box(Space):  # type: ignore[no-redef]
        """Arrays between `low` and `high`, both included."""

        def __init__(self, low: Any, high: Any, shape: Optional[Sequence[int]] = None,
                     dtype: Any = np.float32, seed: Optional[int] = None) -> None:
            super().__init__(np.shape(low) if shape is None else shape, dtype, seed)
            self.low = np.array(np.broadcast_to(low, self.shape), self.dtype)
            self.high = np.array(np.broadcast_to(high, self.shape), self.dtype)

        def sample(self, mask: None = None) -> np.ndarray:
            return self._random.uniform(self.low, self.high, self.shape).astype(self.dtype)

        def contains(self, value: Any) -> bool:
            value = np.asarray(value)
            return bool(np.can_cast(value.dtype, self.dtype) and value.shape == self.shape
                        and np.all(value >= self.low) and np.all(value <= self.high))

        def __eq__(self, other: Any) -> bool:
            return (isinstance(other, Box) and self.dtype == other.dtype
                    and np.array_equal(self.low, other.low)
                    and np.array_equal(self.high, other.high))

        def __repr__(self) -> str:
            return f"Box({self.low.min()}, {self.high.max()}, {self.shape}, {self.dtype})"

    class Discrete(Space):  # type: ignore[no-redef]
        """The integers 0 to n - 1."""

        def __init__(self, n: int, seed: Optional[int] = None) -> None:
            super().__init__((), np.int64, seed)
            self.n = np.int64(n)

        def sample(self, mask: Optional[np.ndarray] = None) -> np.int64:
            """One of the values; with a mask of n numbers, one whose number is not 0."""
            if mask is None:
                return np.int64(self._random.integers(self.n))
            allowed = np.flatnonzero(mask)
            return np.int64(self._random.choice(allowed) if allowed.size else 0)

        def contains(self, value: Any) -> bool:
            integer = isinstance(value, int) or (
                isinstance(value, (np.generic, np.ndarray)) and np.shape(value) == ()
                and np.issubdtype(value.dtype, np.integer))
            return integer and 0 <= int(value) < self.n

        def __eq__(self, other: Any) -> bool:
            return isinstance(other, Discrete) and self.n == other.n

        def __repr__(self) -> str:
            return f"Discrete({self.n})"

    class MultiDiscrete(Space):  # type: ignore[no-redef]
        """Arrays of integers: 0 to nvec[i] - 1 at place i."""

        def __init__(self, nvec: Any, dtype: Any = np.int64, seed: Optional[int] = None) -> None:
            self.nvec = np.array(nvec, dtype)
            super().__init__(self.nvec.shape, dtype, seed)

        def sample(self, mask: Any = None) -> np.ndarray:
            """An integer for each place; with a mask, a tuple of those of Discrete."""
            if mask is None:
                return self._random.integers(self.nvec).astype(self.dtype)
            rows = [self._random.choice(np.flatnonzero(row)) if np.any(row) else 0
                    for row in np.reshape(np.asarray(mask), (self.nvec.size, -1))]
            return np.array(rows, self.dtype).reshape(self.shape)

        def contains(self, value: Any) -> bool:
            value = np.asarray(value)
            return bool(value.shape == self.shape and np.issubdtype(value.dtype, np.integer)
                        and np.all(value >= 0) and np.all(value < self.nvec))

        def __eq__(self, other: Any) -> bool:
            return isinstance(other, MultiDiscrete) and np.array_equal(self.nvec, other.nvec)

        def __repr__(self) -> str:
            return f"MultiDiscrete({self.nvec})"

    class Tuple(Space):  # type: ignore[no-redef]
        """Tuples with one value of each space."""

        def __init__(self, spaces: Iterable[Space], seed: Optional[int] = None) -> None:
            self.spaces = tuple(spaces)
            super().__init__(None, None, seed)
            self.seed(seed)

        def seed(self, seed: Optional[int] = None) -> Any:
            for number, space in enumerate(self.spaces):
                space.seed(None if seed is None else seed + number)
            return seed

        def sample(self, mask: Optional[TupleType[Any, ...]] = None) -> TupleType[Any, ...]:
            """A value of each space; with a mask, a tuple of their masks or None."""
            masks = (None,) * len(self.spaces) if mask is None else mask
            if not isinstance(masks, tuple) or len(masks) != len(self.spaces):
                raise ValueError(f"mask: a tuple of {len(self.spaces)}, not {mask!r:.60}")
            return tuple(space.sample(mask=one) for space, one in zip(self.spaces, masks))

        def contains(self, value: Any) -> bool:
            return (isinstance(value, tuple) and len(value) == len(self.spaces)
                    and all(one in space for one, space in zip(value, self.spaces)))

        def __getitem__(self, index: int) -> Space:
            return self.spaces[index]

        def __len__(self) -> int:
            return len(self.spaces)

        def __eq__(self, other: Any) -> bool:
            return isinstance(other, Tuple) and self.spaces == other.spaces

        def __repr__(self) -> str:
            return f"Tuple({', '.join(map(repr, self.spaces))})"

    class Dict(Space):  # type: ignore[no-redef]
        """Dictionaries with one value of each space."""

        def __init__(self, spaces: DictType[str, Space], seed: Optional[int] = None) -> None:
            self.spaces = dict(spaces)
            super().__init__(None, None, seed)
            self.seed(seed)

        def seed(self, seed: Optional[int] = None) -> Any:
            for number, space in enumerate(self.spaces.values()):
                space.seed(None if seed is None else seed + number)
            return seed

        def sample(self, mask: Optional[DictType[str, Any]] = None) -> DictType[str, Any]:
            return {key: space.sample(mask=(mask or {}).get(key))
                    for key, space in self.spaces.items()}

        def contains(self, value: Any) -> bool:
            return (isinstance(value, dict) and value.keys() == self.spaces.keys()
                    and all(value[key] in space for key, space in self.spaces.items()))

        def __getitem__(self, key: str) -> Space:
            return self.spaces[key]

        def __eq__(self, other: Any) -> bool:
            return isinstance(other, Dict) and self.spaces == other.spaces

        def __repr__(self) -> str:
            return f"Dict({self.spaces})"

    def _batch_space(space: Space, n: int) -> Space:
        return Box(np.stack([space.low] * n), np.stack([space.high] * n), dtype=space.dtype)


def _drawn(space: Space, mask: np.ndarray) -> np.ndarray:
    """For each row of a mask [..., K] an id whose number is not 0; 0 where there is none."""
    if mask.shape[:-1] != space.shape or mask.shape[-1] != space.count:
        raise ValueError(f"mask: shape {mask.shape}, must be {(*space.shape, space.count)}")
    random = space.np_random if HAVE_GYMNASIUM else space._random
    ranks = np.cumsum(mask != 0, axis=-1)
    wanted = (random.random(space.shape) * ranks[..., -1]).astype(np.int64)
    return np.argmax(ranks > wanted[..., None], axis=-1).astype(space.dtype)


class Ids(MultiDiscrete):
    """int64[n] of `count` ids. sample() takes a mask [n, K] as one array, too."""

    def __init__(self, n: int, count: int) -> None:
        super().__init__([count] * n)
        self.count = int(count)

    def sample(self, mask: Any = None, **named: Any) -> np.ndarray:
        """An id for each place. mask: an array [n, K] of which an id may be drawn where it is not
        0, or a tuple of its rows as for MultiDiscrete."""
        return _drawn(self, mask) if isinstance(mask, np.ndarray) else super().sample(mask, **named)


class IdRows(Box):
    """int64[N, n] of `count` ids, as Gymnasium batches a MultiDiscrete; masks [N, n, K]."""

    def __init__(self, rows: int, n: int, count: int) -> None:
        super().__init__(0, count - 1, (rows, n), np.int64)
        self.count = int(count)

    def sample(self, mask: Any = None, **named: Any) -> np.ndarray:
        """An id for each place, drawn where the mask is not 0."""
        if mask is None and HAVE_GYMNASIUM:
            return super().sample(**named)
        return _drawn(self, np.ones((*self.shape, self.count)) if mask is None else mask)


class IdsAndNumbers(Tuple):
    """Ids, or one, and the numbers of actions. sample() takes a mask of the ids, too."""

    def sample(self, mask: Any = None, **named: Any) -> TupleType[Any, ...]:
        """A value of each space. mask: of the ids, or a tuple: that, and None for each other."""
        if isinstance(mask, np.ndarray):
            mask = (mask, *[None] * (len(self.spaces) - 1))
        return super().sample(mask, **named)


def batch_space(space: Space, n: int) -> Space:
    """The space of n values side by side, as the arrays of a vector environment hold them."""
    if isinstance(space, IdsAndNumbers):
        return IdsAndNumbers([batch_space(one, n) for one in space.spaces])
    if isinstance(space, Dict):
        return Dict({key: batch_space(one, n) for key, one in space.spaces.items()})
    if isinstance(space, Discrete):
        return Ids(n, int(space.n))
    if isinstance(space, Ids):
        return IdRows(n, len(space.nvec), space.count)
    return _batch_space(space, n)


__all__: List[str] = ["Box", "Dict", "Discrete", "IdRows", "Ids", "IdsAndNumbers", "MultiDiscrete",
                      "Space", "Tuple", "batch_space", "HAVE_GYMNASIUM"]
