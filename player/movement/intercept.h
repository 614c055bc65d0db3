// Intercept action: executes the best plan of the intercept table.
#pragma once

#include "player/commands/command_slots.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Executes the best plan, or runs to the ball's rest point without one. `face_point` is the body
/// target while waiting. True unless the player is frozen.
bool intercept(const WorldModel& world, CommandSlots& slots, bool save_recovery,
               soccer::Vec2 face_point);

}  // namespace cls::player
