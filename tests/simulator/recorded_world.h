// Worlds as a game log shows them, for senses to be computed from.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "gamelog/record/frame.h"
#include "simulator/world/world.h"

namespace cls::simulator {

/// Rules whose types are seen by everybody at any distance: nothing is missed, so that whatever a
/// recorded see has can be compared.
std::shared_ptr<const Rules> keen_eyed_rules();

/// The world of every frame of a log. What a frame does not hold (how long a tackle, a foul or a
/// gesture lasts) is counted from the frames before; clients are of version 18 in synchronous
/// mode.
std::vector<World> recorded_worlds(std::shared_ptr<const Rules> rules, std::string_view log);

/// A world that a log rounds to the same numbers: every position, velocity and angle moved within
/// its rounding.
World jittered(const World& world, RandomStream& random);

}  // namespace cls::simulator
