// Staying close to the opponents who wait for the ball in front of our goal.
#pragma once

#include <optional>

#include "proxy/formation/formation.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

struct MarkRules {
  double near_goal = 38.0;  ///< metres from our goal within which opponents are marked
  double from_home = 11.0;  ///< metres as far from his place as a marker goes
  double step = 1.3;        ///< metres goalwards of the marked one
};
/// For their dead balls: from a kick-in or a corner kick nobody is offside, so whoever is left
/// alone behind our line is alone with the goalie.
constexpr MarkRules kMarkAtDeadBall{58.0, 20.0, 1.8};

/// Where the agent stands to keep its man from the ball: a step towards our goal of him. Nothing
/// when the ball is ours or far from our goal, and for those who have nobody to look after: each
/// opponent near our goal, the nearest to it first, belongs to the free field player who is
/// nearest to him, by where he is and by his place in the formation (`home`, by unum - 1).
std::optional<soccer::Vec2> mark_point(const WorldModel& world, const TeamPoints& home,
                                       const MarkRules& rules = {});

}  // namespace cls::proxy
