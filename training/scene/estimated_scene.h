// The pitch as an agent estimates it.
#pragma once

#include "player/world/world_model.h"
#include "training/scene/cast.h"

namespace cls::training {

/// Copies a completed world model (player::update_derived) into a scene of the agent's team: what
/// its estimates no longer cover is not seen. A player whose number is unknown takes the first
/// seat of its team in `cast` that is free; one whose team is unknown is left out. Does not
/// allocate.
void fill_scene(const player::WorldModel& world, const Cast& cast, Scene& out);

}  // namespace cls::training
