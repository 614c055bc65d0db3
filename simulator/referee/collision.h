// Ball and players that overlap are pushed apart (3.4).
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

/// Pushes apart until nothing overlaps, at most ten rounds. A contact with the ball is reported to
/// the referee, which may change the mode and move the ball.
void resolve_collisions(World& world, Events& events);

}  // namespace cls::simulator
