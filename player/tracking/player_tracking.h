// Player tracking: prediction, update by see messages, lost players.
#pragma once

#include "player/tracking/observed_object.h"
#include "player/world/world_model.h"
#include "soccer/messages/see.h"

namespace cls::player {

/// Predicts all tracks `cycles` ahead; moves those with an expired position to `lost`.
void advance_players(WorldModel& world, int cycles);

/// Matches the players of a see message with tracks, updates and creates tracks, and counts ghosts:
/// tracks that should have been visible. The own pose must be current.
void observe_players(WorldModel& world, const soccer::See& see);

/// Drops all positions, because players are being placed for a kick-off; the numbers are retained
/// as lost players.
void forget_positions(WorldModel& world);

/// Player list of a side (neutral: unknown team).
PlayerList& list_of(WorldModel& world, soccer::Side side);

/// Appends a track with a new id; a full list drops the track observed longest ago.
PlayerState* new_player(WorldModel& world, soccer::Side side, int unum);

/// Removes a lost player that was found again.
void forget_lost(WorldModel& world, soccer::Side side, int unum);

/// Sorts numbered tracks by number, then the others by id.
void sort_players(PlayerList& list);

/// Conversion between a track and its Gaussian estimate.
ObjectEstimate estimate_of(const PlayerState& player);
void set_estimate(PlayerState& player, const ObjectEstimate& estimate);

}  // namespace cls::player
