// Territory: where play took place.
#pragma once

#include <array>

#include "analysis/play/flow.h"

namespace cls::analysis {

/// Territory of one team in live frames, as it sees the pitch (it attacks +x).
struct TeamTerritory {
  /// Frames with the ball in the own, middle and opponent's third while the team owned it (last
  /// toucher).
  std::array<int, 3> thirds_owned = {};
  int box_entries = 0;  ///< entries of the owned ball into the opponent's penalty area
  int box_touches = 0;  ///< own touches in the opponent's penalty area
  int final_third_touches = 0;
  double pitch_control = 0.0;  ///< mean share of the pitch that the team reaches first
};

struct Territory {
  int frames = 0;
  int live_frames = 0;
  /// As the left team sees the pitch.
  std::array<int, 3> thirds = {};
  std::array<int, 4> quarters = {};
  double mean_ball_x = 0.0;  ///< meters
  PerTeam<TeamTerritory> teams = {};

  /// Left team's share of touches in the final thirds; 0.5 without any.
  double field_tilt() const;
};

/// Pitch control samples every tenth live frame on cells of 5 m; players run straight at top speed.
Territory measure_territory(const Flow& flow);

}  // namespace cls::analysis
