// Worlds reconstructed from a game log, to compute senses from.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "gamelog/record/frame.h"
#include "simulator/world/world.h"

namespace cls::simulator {

/// Rules whose player types have unlimited view distances: no details are missing at random.
std::shared_ptr<const Rules> unlimited_vision_rules();

/// The world of every frame of a log. The remaining time of tackles, fouls and pointing is counted
/// from earlier frames. Clients have version 18 and synchronous view mode.
std::vector<World> recorded_worlds(std::shared_ptr<const Rules> rules, std::string_view log);

/// A world with the same rounded log values: positions, velocities and angles are changed within
/// the rounding.
World jittered(const World& world, RandomStream& random);

}  // namespace cls::simulator
