"""Spaces as Gymnasium's, for where it is not installed: as much of them as cls_gym uses."""
from __future__ import annotations

from typing import Any, Dict as DictType, Iterable, Optional, Sequence, Tuple as TupleType

import numpy as np


class Space:
    """A set of values of one shape and type."""

    def __init__(self, shape: Optional[Sequence[int]], dtype: Any,
                 seed: Optional[int] = None) -> None:
        self.shape: Any = None if shape is None else tuple(int(n) for n in shape)
        self.dtype: Any = None if dtype is None else np.dtype(dtype)
        self._random = np.random.default_rng(seed)

    def seed(self, seed: Optional[int] = None) -> Any:
        """Starts the random numbers of sample() again."""
        self._random = np.random.default_rng(seed)
        return seed

    def __contains__(self, value: Any) -> bool:
        return self.contains(value)

    def contains(self, value: Any) -> bool:
        raise NotImplementedError

    def sample(self, mask: Any = None) -> Any:
        """A random value."""
        raise NotImplementedError


class Box(Space):
    """Arrays between `low` and `high`, both included."""

    def __init__(self, low: Any, high: Any, shape: Optional[Sequence[int]] = None,
                 dtype: Any = np.float32, seed: Optional[int] = None) -> None:
        super().__init__(np.shape(low) if shape is None else shape, dtype, seed)
        self.low = np.array(np.broadcast_to(low, self.shape), self.dtype)
        self.high = np.array(np.broadcast_to(high, self.shape), self.dtype)

    def sample(self, mask: None = None) -> np.ndarray:
        return np.array(self._random.uniform(self.low, self.high, self.shape), self.dtype)

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


class Discrete(Space):
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
        return bool(integer and 0 <= int(value) < self.n)

    def __eq__(self, other: Any) -> bool:
        return isinstance(other, Discrete) and self.n == other.n

    def __repr__(self) -> str:
        return f"Discrete({self.n})"


class MultiDiscrete(Space):
    """Arrays of integers: 0 to nvec[i] - 1 at place i."""

    def __init__(self, nvec: Any, dtype: Any = np.int64, seed: Optional[int] = None) -> None:
        self.nvec = np.array(nvec, dtype)
        super().__init__(self.nvec.shape, dtype, seed)

    def sample(self, mask: Any = None) -> np.ndarray:
        """An integer for each place; with a mask, a tuple of those of Discrete."""
        if mask is None:
            return np.array(self._random.integers(self.nvec), self.dtype)
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


class Tuple(Space):
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


class Dict(Space):
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


def batch_space(space: Any, n: int) -> Box:
    """The space of n values of a Box side by side."""
    return Box(np.stack([space.low] * n), np.stack([space.high] * n), dtype=space.dtype)
