// Keeping the ball at one's feet and away from opponents.
#pragma once

#include <optional>

#include "proxy/commands/command_slots.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Turns toward `face_point` (their goal when none is given) while the ball is safe, else kicks it
/// to the safest place within reach. False when the ball is not kickable.
bool hold_ball(const WorldModel& world, CommandSlots& slots, bool do_turn,
               std::optional<soccer::Vec2> face_point);

}  // namespace cls::proxy
