// Kick-offs and the end without a human (server::auto_mode, 9.16).
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

/// Counts one step; gives the kick-off command when a wait is over, and sets auto_mode.ended some
/// time after the match. Nothing if the parameter auto_mode is off.
void run_auto_mode(World& world, Events& events);

}  // namespace cls::simulator
