// Counting the kicks of a shoot-out.
#pragma once

#include "simulator/world/event.h"

namespace cls::simulator {

// That side's kick has ended: the mode says so, and perhaps the match is decided.
void count_goal(World& world, Side side, Events& events);
void count_miss(World& world, Side side, Events& events);

/// Remembers who has kicked for `side`, so that everybody kicks before anybody kicks again.
void note_kicker(World& world, Side side, const Player& kicker);
bool has_kicked(const World& world, const Player& player);

}  // namespace cls::simulator
