// World model of a player whose server sends the full state.
#pragma once

#include "player/world/world_model.h"
#include "soccer/messages/full_state.h"

namespace cls::proxy {

/// The estimates of a world model, before update_derived(), replaced by the exact positions,
/// velocities and directions of a (fullstate ...) message. Types of opponents are the exact ones,
/// too; what the message does not have (stamina of others, heard messages, the clock) is unchanged.
player::WorldModel full_state_view(const player::WorldModel& world, const soccer::FullState& state);

}  // namespace cls::proxy
