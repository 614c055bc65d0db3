// Getting in the way of an opponent who has the ball.
#pragma once

#include <optional>

#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Where the agent meets an opponent who dribbles towards our goal: on his way, as early as it can
/// be there. Nothing when no opponent has the ball or is about to, when a teammate is there
/// sooner, or when the way is too long.
std::optional<soccer::Vec2> block_point(const WorldModel& world);

}  // namespace cls::proxy
