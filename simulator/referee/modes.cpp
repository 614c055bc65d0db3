// Modes that the automatic referee never sets.
#include "simulator/referee/modes.h"

namespace cls::simulator {

bool is_unusual(PlayMode mode) {
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
