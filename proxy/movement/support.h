// Showing oneself to a teammate who has the ball.
#pragma once

#include <optional>

#include "proxy/formation/formation.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// A place near the own one in the formation (`home`, by unum - 1) where a pass from the teammate
/// with the ball arrives best: an open way, room, their goal near, on side. Nothing in our own
/// half, when the ball is not ours, and for those who are far from it or out of breath.
std::optional<soccer::Vec2> support_point(const WorldModel& world, const TeamPoints& home);

}  // namespace cls::proxy
