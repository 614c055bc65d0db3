// Shooting when nobody can stop the ball.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Shoots between the posts where neither goalie nor opponents reach the ball, from within 30 m.
/// False when there is no such shot, in indirect free kicks, and while the clock stands.
/// `aim`, if given, receives the point shot at.
bool shoot(const WorldModel& world, CommandSlots& slots, soccer::Vec2* aim = nullptr);

}  // namespace cls::proxy
