// Telling kinds of play modes apart.
#pragma once

#include "simulator/world/world.h"

namespace cls::simulator {

/// True for both modes of a pair; `left` is its left one.
constexpr bool is_either(PlayMode mode, PlayMode left) {
  return mode == left || static_cast<int>(mode) == static_cast<int>(left) + 1;
}

constexpr bool is_goal(PlayMode mode) { return is_either(mode, PlayMode::kGoalLeft); }

constexpr bool is_goal_kick(PlayMode mode) { return is_either(mode, PlayMode::kGoalKickLeft); }

constexpr bool is_foul(PlayMode mode) {
  return is_either(mode, PlayMode::kFoulChargeLeft) || is_either(mode, PlayMode::kFoulPushLeft);
}

/// Modes that only a trainer sets.
bool is_unusual(PlayMode mode);

}  // namespace cls::simulator
