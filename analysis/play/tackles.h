// Tackles: tried, reached the ball, and whether they won it.
#pragma once

#include "analysis/play/flow.h"

namespace cls::analysis {

struct Tackles {
  int tried = 0;
  int succeeded = 0;  ///< the ball was hit
  int failed = 0;     ///< by chance
  int out_of_reach = 0;
  int effective = 0;  ///< hit, the ball was the opponent's, the own team touched it next
  int as_kick = 0;    ///< hit while the ball was the own team's: a hard kick

  friend bool operator==(const Tackles&, const Tackles&) = default;
};

/// All frames but penalties. Without tackle counters (before version 4) by the state bits.
PerPlayer<Tackles> tackles_of(const Flow& flow);

}  // namespace cls::analysis
