// Where players stood, and the shape of the teams.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "analysis/play/flow.h"

namespace cls::analysis {

/// Cells of 5 m; row-major, from the left team's top left corner. Outside the pitch counts for the
/// border cells.
constexpr std::size_t kHeatColumns = 21;
constexpr std::size_t kHeatRows = 14;
using HeatMap = std::array<int, kHeatColumns * kHeatRows>;

/// A cloud of positions: mean and covariance.
struct Cloud {
  int count = 0;
  soccer::Vec2 mean;
  double var_x = 0.0;
  double var_y = 0.0;
  double cov_xy = 0.0;
};

/// One player, as his team sees the pitch (it attacks +x). Live frames.
struct Positions {
  Cloud all;
  soccer::Vec2 mean_own_ball;  ///< own team owns the ball
  soccer::Vec2 mean_opponent_ball;
  HeatMap heat = {};  ///< not mirrored: left team's view for all
};

/// Means over every tenth live frame; connected players without the goalkeeper.
struct TeamShape {
  double length = 0.0;  ///< metres along the pitch
  double width = 0.0;
  double hull_area = 0.0;      ///< square metres
  double compactness = 0.0;    ///< mean distance from the team's centre
  double defence_x = 0.0;      ///< mean x of the three rearmost, from the own view
  double line_distance = 0.0;  ///< between the lines of the formation
  std::string formation;       ///< "4-3-3": lines from the rear, by average positions; may be empty
};

struct PositionStats {
  PerPlayer<Positions> players;
  PerTeam<TeamShape> teams;
  HeatMap ball = {};
};

PositionStats positions_of(const Flow& flow);

}  // namespace cls::analysis
