// The built-in choice of player types (docs/spec/proxy-behavior.md 6.2).
#pragma once

#include <vector>

#include "player/world/world_model.h"
#include "proxy/coach/coach_memory.h"
#include "soccer/commands/coach_command.h"

namespace cls::proxy {

/// Appends the changes that are due now. Once before the kick-off: type 0 for the goalie, the
/// fastest types for the others, forwards and defenders first. In the last 500 cycles of normal
/// time, during stoppages: fresh players for those with reduced recovery, lowest first. Never more
/// than the rules allow.
void substitute(const player::WorldModel& world, CoachMemory& memory,
                std::vector<soccer::CoachCommand>& out);

}  // namespace cls::proxy
