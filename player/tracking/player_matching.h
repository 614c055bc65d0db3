// Data association: matches the players of a see message with tracks.
#pragma once

#include "player/tracking/observed_object.h"
#include "player/world/world_model.h"
#include "soccer/messages/see.h"

namespace cls::player {

/// A player in a see message.
struct PlayerObservation {
  const soccer::Observation* seen = nullptr;
  ObservedPosition observed;
  Side side = Side::kNeutral;
};

using PlayerObservationList = base::FixedList<PlayerObservation, 24>;

/// Updates a track by an observation and marks it as matched.
using UpdateTrack = void (*)(PlayerState& track, const Viewpoint& view,
                             const PlayerObservation& observation);

/// Calls `update` with the matching track of every observation. Numbered players match by number;
/// swapped numbers are corrected. The others match by minimum total cost, with a new track as
/// alternative. Tracks without observation stay unmatched.
void match_players(WorldModel& world, const Viewpoint& view,
                   const PlayerObservationList& observations, UpdateTrack update);

}  // namespace cls::player
