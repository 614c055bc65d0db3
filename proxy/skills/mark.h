// Staying close to the opponents who wait for the ball in front of our goal.
#pragma once

#include <optional>

#include "proxy/formation/formation.h"
#include "proxy/world_model.h"

namespace cls::proxy {

/// Where the agent stands to keep its man from the ball: a step towards our goal of him. Nothing
/// when the ball is ours or far from our goal, and for those who have nobody to look after: each
/// opponent near our goal, the nearest to it first, belongs to the free field player whose place
/// in the formation (`home`, by unum - 1) is nearest to him.
std::optional<soccer::Vec2> mark_point(const WorldModel& world, const TeamPoints& home);

}  // namespace cls::proxy
