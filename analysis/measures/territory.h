// Where the game was played.
#pragma once

#include <array>

#include "analysis/play/flow.h"

namespace cls::analysis {

/// From one team's view, whose own goal is on the left. Live frames.
struct TeamTerritory {
  /// Frames with the ball in the own third, the middle, the opponent's third while the team owned
  /// it (last toucher).
  std::array<int, 3> thirds_owned = {};
  int box_entries = 0;  ///< the ball came into the opponent's penalty area while owned
  int box_touches = 0;  ///< own touches there
  int final_third_touches = 0;
  double pitch_control = 0.0;  ///< mean share of the pitch that the team would reach first
};

struct Territory {
  int frames = 0;
  int live_frames = 0;
  /// As the left team sees it.
  std::array<int, 3> thirds = {};
  std::array<int, 4> quarters = {};
  double mean_ball_x = 0.0;  ///< metres
  PerTeam<TeamTerritory> teams = {};

  /// Left's part of both teams' touches in their opponents' third; 0.5 without any.
  double field_tilt() const;
};

/// Pitch control looks at every tenth live frame and cells of 5 m; a player runs straight at his
/// top speed.
Territory territory_of(const Flow& flow);

}  // namespace cls::analysis
