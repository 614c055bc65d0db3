// Counting the kicks of a shoot-out.
#pragma once

#include "simulator/event.h"

namespace cls::simulator {

// The kick of the side whose turn it is has ended: the mode says so, and perhaps the match is
// decided.
void count_goal(World& world, Events& events);
void count_miss(World& world, Events& events);

/// Remembers who has kicked, so that everybody kicks before anybody kicks again.
void note_kicker(World& world, const Player& kicker);
bool has_kicked(const World& world, const Player& player);

}  // namespace cls::simulator
