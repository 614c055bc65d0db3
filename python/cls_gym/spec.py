"""What an environment has: agents, features, actions, rewards, with names, units and bounds."""
from __future__ import annotations

from typing import Any, Dict, NamedTuple, Tuple

import numpy as np

from cls_gym import spaces


class Feature(NamedTuple):
    """One number of an observation."""

    name: str
    unit: str
    low: float
    high: float


class Sense(NamedTuple):
    """A choice beside the action: the number of one of `items`; 0 is what agents of matches do."""

    name: str
    items: Tuple[str, ...]


class ActionSet(NamedTuple):
    """What an agent can do: one of `names` (if any), with numbers (if any) for `values`, and
    choices of its senses (with look and say)."""

    name: str
    version: int
    names: Tuple[str, ...]
    parameters: Tuple[Tuple[Feature, ...], ...]  # of each action of `names`
    values: Tuple[Feature, ...]                  # the numbers that the engine reads
    senses: Tuple[Sense, ...] = ()

    def _ids(self, agents: int) -> spaces.Space[Any]:
        n = len(self.names)
        if self.senses:
            counts = [n, *(len(sense.items) for sense in self.senses)]
            return spaces.IdsAndSenses(counts, () if agents == 1 else (agents,))
        return spaces.Discrete(n) if agents == 1 else spaces.Ids(agents, n)

    def space(self, agents: int) -> spaces.Space[Any]:
        """The space of one agent's action, or of `agents` actions side by side.

        Discrete; Box; or Tuple(Discrete, Box...): which action, then the numbers of each action
        that has some, scaled to -1..1. With senses it is MultiDiscrete instead of Discrete: which
        action, then the number of an item of each of `senses`.
        """
        if not self.values:
            return self._ids(agents)
        if not self.names:
            one: spaces.Space[Any] = _box(self.values)
        else:
            one = spaces.IdsAndNumbers([self._ids(1),
                                        *(spaces.Box(-1.0, 1.0, (len(own),), np.float32)
                                          for own in self.parameters if own)])
        return one if agents == 1 else spaces.batch_space(one, agents)


class Spec(NamedTuple):
    """The description that the engine prints for a configuration; `document` has all of it."""

    task: str
    agents: Tuple[str, ...]
    feature_set: str
    feature_version: int
    features: Tuple[Feature, ...]
    state_features: Tuple[Feature, ...]
    actions: ActionSet
    reward_terms: Tuple[str, ...]
    statuses: Tuple[str, ...]
    options: Tuple[str, ...]
    opponents: Tuple[str, ...]  #: who plays them; info["opponent"] is an index
    document: Dict[str, Any]

    def observation_space(self, agents: int, mask: str = "info") -> spaces.Space[Any]:
        """float32[F], or float32[agents, F]. mask "appended": with K masks, 0 or 1, after the
        features; "observation": a Dict of `observation` and the ids' mask, int8[K]."""
        low, high = bounds(self.features)
        ids = len(self.actions.names)
        if mask == "appended":
            low, high = np.append(low, np.zeros(ids, np.float32)), \
                np.append(high, np.ones(ids, np.float32))
        shape = (len(low),) if agents == 1 else (agents, len(low))
        box = spaces.Box(np.broadcast_to(low, shape), np.broadcast_to(high, shape),
                         dtype=np.float32)
        if mask != "observation":
            return box
        name = "id_mask" if self.actions.values else "action_mask"
        return spaces.Dict({"observation": box,
                            name: spaces.Box(0, 1, (*shape[:-1], ids), np.int8)})

    def state_space(self) -> spaces.Box:
        """float32[S]: the full state for a central critic."""
        return _box(self.state_features)


def _box(features: Tuple[Feature, ...]) -> spaces.Box:
    return spaces.Box(*bounds(features), dtype=np.float32)


def bounds(features: Tuple[Feature, ...]) -> Tuple[np.ndarray, np.ndarray]:
    """Lowest and highest values of features, float32."""
    return (np.array([one.low for one in features], np.float32),
            np.array([one.high for one in features], np.float32))
