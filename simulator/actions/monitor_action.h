// What monitors may do to the world: the human referee (simulation model 10.2).
#pragma once

#include "simulator/world/event.h"
#include "soccer/commands/monitor_command.h"

namespace cls::simulator {

/// Carries out a command. Those that are the session's business, players who are not on the pitch
/// and set plays during a shoot-out have no effect.
void apply(World& world, const soccer::MonitorCommand& command, Events& events);

}  // namespace cls::simulator
