// Two scripted teams whose matches contain every kind of event.
#pragma once

#include <cstdint>

#include "simulator/world/event.h"
#include "simulator/world/world.h"

namespace cls::tests {

/// A world with two full teams before the first kick-off.
simulator::World full_match(const soccer::ServerParams& server, std::uint64_t seed);

/// Plays one cycle with full information: the closest player of a team runs to the ball and kicks
/// it toward the opponent goal, the others keep their positions, goalies catch. Kicks off
/// automatically.
void play_cycle(simulator::World& world, simulator::Events& events);

/// Hash over clock, mode, positions, velocities, angles, stamina, counters and random streams.
std::uint64_t fingerprint(const simulator::World& world);

}  // namespace cls::tests
