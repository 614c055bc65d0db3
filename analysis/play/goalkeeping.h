// What the goalkeepers did.
#pragma once

#include <vector>

#include "analysis/play/flow.h"
#include "analysis/play/shots.h"

namespace cls::analysis {

/// One team's goalkeeper (whoever has the goalie bit).
struct Goalkeeping {
  int catches = 0;
  int punches = 0;         ///< catches that failed by chance
  int failed_catches = 0;  ///< out of reach, or not allowed
  int saves = 0;           ///< shots that he stopped
  int conceded_on_target = 0;
  int moves_after_catch = 0;
  soccer::Vec2 mean_position;  ///< ball in the own third, as his team sees it; live frames
  double furthest_rush = 0.0;  ///< metres from the centre of the own goal; live frames

  /// Saves of all shots on target that were saved or went in; 0 without any.
  double save_rate() const {
    const int faced = saves + conceded_on_target;
    return faced == 0 ? 0.0 : static_cast<double>(saves) / faced;
  }
};

PerTeam<Goalkeeping> goalkeeping_of(const Flow& flow, const std::vector<Shot>& shots);

}  // namespace cls::analysis
