// Which track each player of a look is.
#pragma once

#include "proxy/tracking/observed_object.h"
#include "proxy/world/world_model.h"
#include "soccer/messages/see.h"

namespace cls::proxy {

/// A player of the look.
struct PlayerSighting {
  const soccer::Observation* seen = nullptr;
  Sight sight;
  soccer::Side side = soccer::Side::kNeutral;
};

using SightingList = FixedList<PlayerSighting, 24>;

/// Takes a sighting into a track (and claims it).
using TakeSighting = void (*)(PlayerState& track, const Viewpoint& view,
                              const PlayerSighting& sighting);

/// Gives every sighting to a track by `take`: those with a number to the track of that number,
/// where tracks turn out to have been mixed up their numbers change hands; the others so that all
/// together fit best, with a new track as the alternative. Tracks left without a sighting stay
/// unclaimed.
void match(WorldModel& world, const Viewpoint& view, const SightingList& sightings,
           TakeSighting take);

}  // namespace cls::proxy
