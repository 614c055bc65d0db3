// The pitch as an agent estimates it.
#pragma once

#include "proxy/world/world_model.h"
#include "training/scene/cast.h"

namespace cls::training {

/// Copies a completed world model (proxy::update_derived) into a scene of the agent's team: what
/// its estimates no longer cover is not seen. A player whose number is unknown takes the first
/// seat of its team in `cast` that is free; one whose team is unknown is left out. Does not
/// allocate.
void fill_scene(const proxy::WorldModel& world, const Cast& cast, Scene& out);

}  // namespace cls::training
