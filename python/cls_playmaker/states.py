"""States that a match sends without the players that they have twice."""
from __future__ import annotations

from cls_playmaker import proto


def complete_state(state: proto.State) -> proto.State:
    """Adds to the dictionaries of players those of `teammates` and `opponents`; returns `state`.

    Only a Playmaker with `lean_states` needs it, and only if it reads `our_players_dict` or
    `their_players_dict`. A State with all entries stays as it is.
    """
    world = state.world_model
    for players, entries in ((world.teammates, world.our_players_dict),
                             (world.opponents, world.their_players_dict)):
        for player in players:
            if player.uniform_number > 0 and player.uniform_number not in entries:
                entries[player.uniform_number].CopyFrom(player)
    return state
