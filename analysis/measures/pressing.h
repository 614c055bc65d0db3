// How the teams win the ball back.
#pragma once

#include <vector>

#include "analysis/play/flow.h"
#include "analysis/play/passes.h"
#include "analysis/play/stoppages.h"

namespace cls::analysis {

/// What one team does against the other (match-statistics 3.10).
struct Pressing {
  int opponent_passes = 0;     ///< attempted within the opponent's 60 % of the pitch
  int defensive_actions = 0;   ///< own tackles, interceptions and fouls there
  int pressure_frames = 0;     ///< opponent owns the ball, one of ours within 3 m of the owner
  int opponent_frames = 0;     ///< opponent owns the ball
  int recoveries = 0;          ///< first touch after the opponent's
  int losses = 0;              ///< the ball went to the opponent in play
  int regained_soon = 0;       ///< within 20 cycles
  int regained = 0;            ///< in the same live phase
  double regain_cycles = 0.0;  ///< mean, of those

  /// Opponent's passes for each own action; 0 without any action.
  double passes_per_action() const {
    return defensive_actions == 0 ? 0.0 : static_cast<double>(opponent_passes) / defensive_actions;
  }
};

struct PressingStats {
  PerTeam<Pressing> teams;
  PerPlayer<int> interceptions = {};  ///< opponents' passes that he touched next
  PerPlayer<int> recoveries = {};
};

PressingStats pressing_of(const Flow& flow, const std::vector<Pass>& passes,
                          const Stoppages& stoppages);

}  // namespace cls::analysis
