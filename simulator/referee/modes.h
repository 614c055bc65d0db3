// Groups of play modes.
#pragma once

#include "simulator/world/world.h"

namespace cls::simulator {

/// True for both modes of a left/right pair; `left` is its left mode.
constexpr bool is_either(PlayMode mode, PlayMode left) {
  return mode == left || static_cast<int>(mode) == static_cast<int>(left) + 1;
}

constexpr bool is_goal(PlayMode mode) { return is_either(mode, PlayMode::kGoalLeft); }

constexpr bool is_goal_kick(PlayMode mode) { return is_either(mode, PlayMode::kGoalKickLeft); }

constexpr bool is_foul(PlayMode mode) {
  return is_either(mode, PlayMode::kFoulChargeLeft) || is_either(mode, PlayMode::kFoulPushLeft);
}

// Phases of a kick in a shoot-out.
constexpr bool is_penalty_setup(PlayMode mode) {
  return is_either(mode, PlayMode::kPenaltySetupLeft);
}
constexpr bool is_penalty_ready(PlayMode mode) {
  return is_either(mode, PlayMode::kPenaltyReadyLeft);
}
constexpr bool is_penalty_taken(PlayMode mode) {
  return is_either(mode, PlayMode::kPenaltyTakenLeft);
}
constexpr bool is_between_penalties(PlayMode mode) {
  return is_either(mode, PlayMode::kPenaltyMissLeft) ||
         is_either(mode, PlayMode::kPenaltyScoreLeft);
}

/// Modes that the automatic referee never sets; only a trainer can.
constexpr bool is_trainer_only_mode(PlayMode mode) {
  switch (mode) {
    case PlayMode::kNull:
    case PlayMode::kPenaltyKickLeft:
    case PlayMode::kPenaltyKickRight:
    case PlayMode::kFirstHalfOver:
    case PlayMode::kPause:
    case PlayMode::kHumanJudge:
    case PlayMode::kFoulMultipleAttackLeft:
    case PlayMode::kFoulMultipleAttackRight:
    case PlayMode::kFoulBallOutLeft:
    case PlayMode::kFoulBallOutRight:
      return true;
    default:
      return false;
  }
}

}  // namespace cls::simulator
