// World model for a shoot-out: the taking team attacks +x, whichever goal is used.
#pragma once

#include "player/world/world_model.h"

namespace cls::proxy {

/// True in a shoot-out when the goal in use is on the wrong side: all kicks go to one goal, so one
/// team attacks its own side and the other defends the opposite one.
bool needs_shoot_out_view(const player::WorldModel& world);

/// The world model rotated by 180 degrees about the center. Commands are relative to the body, so a
/// decision is valid in both views.
player::WorldModel rotated(const player::WorldModel& world);

}  // namespace cls::proxy
