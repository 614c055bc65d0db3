"""Spaces of observations and actions: Gymnasium's where it is installed, else small ones alike.

The small ones have what training loops use: `shape`, `dtype`, `n`, `low`, `high`, `sample()`,
`seed()`, `contains()`, `in`, `==`.
"""
from __future__ import annotations

from typing import Any, List, Sequence, Tuple as TupleType

import numpy as np

try:
    from gymnasium.spaces import (  # type: ignore[import-not-found,unused-ignore]
        Box, Dict, Discrete, MultiDiscrete, Space, Tuple)
    from gymnasium.vector.utils import (  # type: ignore[import-not-found,unused-ignore]
        batch_space as _batch_space)

    HAVE_GYMNASIUM = True
except ImportError:
    from cls_gym._spaces import (  # type: ignore[assignment,unused-ignore]
        Box, Dict, Discrete, MultiDiscrete, Space, Tuple, batch_space as _batch_space)

    HAVE_GYMNASIUM = False


def _drawn(space: Any, mask: np.ndarray, shape: Sequence[int]) -> np.ndarray:
    """For each row of a mask [*shape, K] an id whose number is not 0; 0 where there is none."""
    if mask.shape != (*shape, space.count):
        raise ValueError(f"mask: shape {mask.shape}, must be {(*shape, space.count)}")
    random = space.np_random if HAVE_GYMNASIUM else space._random
    ranks = np.cumsum(mask != 0, axis=-1)
    wanted = (random.random(shape) * ranks[..., -1]).astype(np.int64)
    drawn: np.ndarray = np.argmax(ranks > wanted[..., None], axis=-1).astype(space.dtype)
    return drawn


class Ids(MultiDiscrete):  # type: ignore[misc,unused-ignore]
    """int64[n] of `count` ids. sample() takes a mask [n, K] as one array, too."""

    def __init__(self, n: int, count: int) -> None:
        super().__init__([count] * n)
        self.count = int(count)

    def sample(  # type: ignore[override,unused-ignore]
            self, mask: Any = None, **named: Any) -> np.ndarray:
        """An id for each place. mask: an array [n, K] of which an id may be drawn where it is not
        0, or a tuple of its rows as for MultiDiscrete."""
        if isinstance(mask, np.ndarray):
            return _drawn(self, mask, self.shape)
        return np.asarray(super().sample(mask, **named))


class IdRows(Box):  # type: ignore[misc,unused-ignore]
    """int64[N, n] of `count` ids, as Gymnasium batches a MultiDiscrete; masks [N, n, K]."""

    def __init__(self, rows: int, n: int, count: int) -> None:
        super().__init__(0, count - 1, (rows, n), np.int64)
        self.count = int(count)

    def sample(  # type: ignore[override,unused-ignore]
            self, mask: Any = None, **named: Any) -> np.ndarray:
        """An id for each place, drawn where the mask is not 0."""
        if mask is None and HAVE_GYMNASIUM:
            return np.asarray(super().sample(**named))
        return _drawn(self, np.ones((*self.shape, self.count)) if mask is None else mask,
                      self.shape)


class IdsAndSenses(MultiDiscrete):  # type: ignore[misc,unused-ignore]
    """int64[..., 1 + H]: an id, then the number of an item of each of H senses. sample() takes a
    mask [..., K] of the ids as one array, too."""

    def __init__(self, counts: Sequence[int], rows: Sequence[int] = ()) -> None:
        super().__init__(np.tile(np.asarray(counts), (*rows, 1)))
        self.counts, self.count = tuple(int(one) for one in counts), int(counts[0])

    def sample(  # type: ignore[override,unused-ignore]
            self, mask: Any = None, **named: Any) -> np.ndarray:
        """Numbers for each place. mask: an array [..., K] of which an id may be drawn where it is
        not 0, or a tuple as for MultiDiscrete."""
        if not isinstance(mask, np.ndarray):
            return np.asarray(super().sample(mask, **named))
        drawn = np.array(super().sample(**named))
        drawn[..., 0] = _drawn(self, mask, self.shape[:-1])
        return drawn


class IdsAndNumbers(Tuple):  # type: ignore[misc,type-arg,unused-ignore]
    """Ids, or one, and the numbers of actions. sample() takes a mask of the ids, too."""

    def sample(  # type: ignore[override,unused-ignore]
            self, mask: Any = None, **named: Any) -> TupleType[Any, ...]:
        """A value of each space. mask: of the ids, or a tuple: that, and None for each other."""
        if isinstance(mask, np.ndarray):
            mask = (mask, *[None] * (len(self.spaces) - 1))
        return tuple(super().sample(mask, **named))


def batch_space(space: Space[Any], n: int) -> Space[Any]:
    """The space of n values side by side, as the arrays of a vector environment hold them."""
    if isinstance(space, IdsAndNumbers):
        return IdsAndNumbers([batch_space(one, n) for one in space.spaces])
    if isinstance(space, Dict):
        return Dict({key: batch_space(one, n) for key, one in space.spaces.items()})
    if isinstance(space, Discrete):
        return Ids(n, int(space.n))
    if isinstance(space, IdsAndSenses):
        return IdsAndSenses(space.counts, (n, *space.shape[:-1]))
    if isinstance(space, Ids):
        return IdRows(n, len(space.nvec), space.count)
    return _batch_space(space, n)


__all__: List[str] = ["Box", "Dict", "Discrete", "IdRows", "Ids", "IdsAndNumbers",
                      "IdsAndSenses", "MultiDiscrete", "Space", "Tuple", "batch_space", "HAVE_GYMNASIUM"]
