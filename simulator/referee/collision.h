// Collisions of players with the ball and with each other (docs/spec/simulation-model.md 3.4).
#pragma once

#include "simulator/referee/overlaps.h"
#include "simulator/world/event.h"

namespace cls::simulator {

/// Separates overlapping objects in at most ten rounds. Contacts with the ball are reported to the
/// referee, which may change the mode and move the ball.
void resolve_collisions(World& world, Events& events);

/// The same; `bodies` is what the previous call left, or empty. Only players that have moved or
/// changed their size since then are compared with the others.
void resolve_collisions(World& world, Bodies& bodies, Events& events);

}  // namespace cls::simulator
