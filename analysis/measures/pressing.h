// Pressing: how teams regain the ball.
#pragma once

#include <vector>

#include "analysis/play/flow.h"
#include "analysis/play/passes.h"
#include "analysis/play/stoppages.h"

namespace cls::analysis {

/// Pressing of one team (docs/spec/match-statistics.md 3.10).
struct Pressing {
  int opponent_passes = 0;     ///< attempted in the opponent's own 60 % of the pitch
  int defensive_actions = 0;   ///< own tackles, interceptions and fouls there
  int pressure_frames = 0;     ///< opponent owner with one of this team within 3 m
  int opponent_frames = 0;     ///< opponent owns the ball
  int recoveries = 0;          ///< first touch after the opponent's
  int losses = 0;              ///< ball lost to the opponent in play
  int regained_soon = 0;       ///< within 20 cycles
  int regained = 0;            ///< regained in the same live phase
  double regain_cycles = 0.0;  ///< mean cycles of regained losses

  /// Opponent passes per defensive action (PPDA); 0 without any action.
  double passes_per_action() const {
    return defensive_actions == 0 ? 0.0 : static_cast<double>(opponent_passes) / defensive_actions;
  }
  /// Share of the opponent's frames under pressure.
  double pressure() const {
    return opponent_frames == 0 ? 0.0 : static_cast<double>(pressure_frames) / opponent_frames;
  }
};

struct PressingStats {
  PerTeam<Pressing> teams;
  PerPlayer<int> interceptions = {};  ///< opponent passes that the player touched next
  PerPlayer<int> recoveries = {};
};

PressingStats measure_pressing(const Flow& flow, const std::vector<Pass>& passes,
                               const Stoppages& stoppages);

}  // namespace cls::analysis
