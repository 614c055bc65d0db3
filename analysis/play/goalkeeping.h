// Statistics of the goalies.
#pragma once

#include <vector>

#include "analysis/play/flow.h"
#include "analysis/play/shots.h"

namespace cls::analysis {

/// Goalie of one team: the player with the goalie bit.
struct Goalkeeping {
  int catches = 0;
  int punches = 0;         ///< catches that failed by chance
  int failed_catches = 0;  ///< out of reach, or illegal
  int saves = 0;           ///< shots stopped
  int conceded_on_target = 0;
  int moves_after_catch = 0;
  soccer::Vec2 mean_position;  ///< while the ball is in the own third, as the team sees the pitch;
                               ///< live frames
  double furthest_rush = 0.0;  ///< meters from the center of the own goal; live frames

  /// Share of saves in shots on target; 0 without any.
  double save_rate() const {
    const int faced = saves + conceded_on_target;
    return faced == 0 ? 0.0 : static_cast<double>(saves) / faced;
  }
};

PerTeam<Goalkeeping> measure_goalkeeping(const Flow& flow, const std::vector<Shot>& shots);

}  // namespace cls::analysis
