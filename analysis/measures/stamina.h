// What running cost.
#pragma once

#include "analysis/play/flow.h"

namespace cls::analysis {

struct Stamina {
  double used = 0.0;           ///< exact where the log has the capacity, else reckoned by the rules
  double lowest = 0.0;         ///< lowest stamina
  double last = 0.0;           ///< at the end
  double last_capacity = 0.0;  ///< -1: not in the log
  int exhausted_frames = 0;    ///< capacity used up, or stamina below the effort threshold
  int tired_frames = 0;        ///< stamina below the recovery threshold
  int lowered_recovery_frames = 0;  ///< recovery below its start
  int lowered_effort_frames = 0;    ///< effort below the type's
  int refills = 0;                  ///< second half, substitution, trainer
};

/// All frames in which a player is connected (match-statistics 4.2). Nothing for versions 1 and 2.
PerPlayer<Stamina> stamina_of(const gamelog::MatchRecord& record);

}  // namespace cls::analysis
