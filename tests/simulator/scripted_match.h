// Two teams of simple reflexes: enough to make everything happen in a match.
#pragma once

#include <cstdint>

#include "simulator/world/event.h"
#include "simulator/world/world.h"

namespace cls::tests {

/// A world with two full teams, right before its first kick-off.
simulator::World full_match(const soccer::ServerParams& server, std::uint64_t seed);

/// One cycle: everybody sees everything; whoever is nearest runs to the ball and kicks it towards
/// the other goal, the others keep their places; goalies catch. Kicks off by itself.
void play_cycle(simulator::World& world, simulator::Events& events);

/// A number that two worlds share only if every position, velocity, counter, mode and stream does.
std::uint64_t fingerprint(const simulator::World& world);

}  // namespace cls::tests
