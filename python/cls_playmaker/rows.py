"""Numbers instead of States: what a trained policy observes and returns (docs/wire.md, TENSOR)."""
from __future__ import annotations

from typing import Dict, List, NamedTuple

from cls_playmaker import proto


class RowForm(NamedTuple):
    """Which numbers. `cls train spec` lists the sets; NAME/VERSION, such as "ego/1"."""

    feature_set: str
    action_set: str
    teammates: int  # of an observation, without the agent: 0 to 10
    opponents: int  # 0 to 11


class TeamRows(NamedTuple):
    """The players that are due. Arrays are bytes in row-major order, a row per player."""

    cycle: int
    play_mode: str      # as the soccer server names it: "play_on", "kick_off_l"
    players: List[int]  # uniform numbers, ascending
    features: bytes     # float32[players, features]
    masks: bytes        # uint8[players, ids]; empty for an action set without ids


class TeamActions(NamedTuple):
    """`rows`: float32[players, 1 + values], the id and the values of the action set; without ids
    float32[players, values]; empty if `replies` has all players. `width` is the second number.
    `replies`: actions of the wire, which replace the row of their player."""

    rows: bytes
    width: int
    replies: Dict[int, proto.PlayerActions]
