// Following the other players: their motion, who of them a look shows, and who is gone.
#pragma once

#include "proxy/tracking/observed_object.h"
#include "proxy/world/world_model.h"
#include "soccer/messages/see.h"

namespace cls::proxy {

/// Advances all tracks by `cycles`; those not seen or heard for too long are lost.
void advance_players(WorldModel& world, int cycles);

/// Matches the players of a look with the tracks, updates them, makes new ones, and counts looks
/// that should have shown a track and did not. The own pose is up to date.
void observe_players(WorldModel& world, const soccer::See& see);

/// Everybody may stand anywhere by now (a kick-off is prepared): only the numbers that play are
/// remembered.
void forget_places(WorldModel& world);

/// The list of that side's players (neutral: of those whose team is not known).
PlayerList& list_of(WorldModel& world, soccer::Side side);

/// A new track at the end of that list, under a new id; when the list is full the track without
/// news for the longest time makes room.
PlayerState* new_player(WorldModel& world, soccer::Side side, int unum);

/// The player with that number has been found.
void forget_lost(WorldModel& world, soccer::Side side, int unum);

/// Numbered tracks by number, then the others by age of the track.
void sort_players(PlayerList& list);

/// The track's belief, and back.
MovingBelief belief_of(const PlayerState& player);
void set_belief(PlayerState& player, const MovingBelief& belief);

}  // namespace cls::proxy
