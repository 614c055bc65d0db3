// Getting to the ball by the best of the plans in the intercept table.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Begins the best plan, or goes where the ball comes to rest when there is none. `face_point` is
/// what the body turns to when no running is needed. Always true, except on the ground.
bool intercept(const WorldModel& world, CommandSlots& slots, bool save_recovery,
               soccer::Vec2 face_point);

}  // namespace cls::proxy
