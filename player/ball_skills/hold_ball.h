// Hold action: keeps the ball away from opponents.
#pragma once

#include <optional>

#include "player/commands/command_slots.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Turns toward `face_point` (default: their goal) while the ball is safe, otherwise kicks it to
/// the safest point in reach. False if the ball is not kickable.
bool hold_ball(const WorldModel& world, CommandSlots& slots, bool do_turn,
               std::optional<soccer::Vec2> face_point);

}  // namespace cls::player
