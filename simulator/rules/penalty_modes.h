// The phases of a kick in a shoot-out, either side's.
#pragma once

#include "simulator/referee/modes.h"

namespace cls::simulator {

constexpr bool is_setup(PlayMode mode) { return is_either(mode, PlayMode::kPenaltySetupLeft); }
constexpr bool is_ready(PlayMode mode) { return is_either(mode, PlayMode::kPenaltyReadyLeft); }
constexpr bool is_taken(PlayMode mode) { return is_either(mode, PlayMode::kPenaltyTakenLeft); }
constexpr bool is_between_kicks(PlayMode mode) {
  return is_either(mode, PlayMode::kPenaltyMissLeft) ||
         is_either(mode, PlayMode::kPenaltyScoreLeft);
}

}  // namespace cls::simulator
