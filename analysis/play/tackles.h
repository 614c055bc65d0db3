// Tackles and their outcomes.
#pragma once

#include "analysis/play/flow.h"

namespace cls::analysis {

struct Tackles {
  int tried = 0;
  int succeeded = 0;  ///< the ball was hit
  int failed = 0;     ///< by chance
  int out_of_reach = 0;
  int effective = 0;  ///< hit the opponent's ball, and the own team touched it next
  int as_kick = 0;    ///< hit the own team's ball: a hard kick

  friend bool operator==(const Tackles&, const Tackles&) = default;
};

/// All frames except penalties. Without tackle counters (before version 4) by the state bits.
PerPlayer<Tackles> count_tackles(const Flow& flow);

}  // namespace cls::analysis
