// The pitch as the players of a shoot-out see it: takers attack +x, whichever goal is in use.
#pragma once

#include "proxy/world/world_model.h"

namespace cls::proxy {

/// True in a shoot-out at the goal that lies the other way round: all kicks go to one goal, so one
/// team attacks what is its own side, and the other defends what is not.
bool turned_for_shoot_out(const WorldModel& world);

/// The beliefs turned by 180 degrees about the centre. Commands are relative to the body, so what
/// is decided in one view holds in the other.
WorldModel turned(const WorldModel& world);

}  // namespace cls::proxy
