// Positions of players and shapes of teams.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "analysis/play/flow.h"
#include "gamelog/record/match_record.h"
#include "soccer/geometry.h"

namespace cls::analysis {

/// Cells of 5 m; row-major, from the left team's top left corner. Positions outside the pitch count
/// for the border cells.
constexpr std::size_t kHeatColumns = 21;
constexpr std::size_t kHeatRows = 14;
using HeatMap = std::array<int, kHeatColumns * kHeatRows>;

/// Mean and covariance of positions.
struct Cloud {
  int count = 0;
  soccer::Vec2 mean;
  double var_x = 0.0;
  double var_y = 0.0;
  double cov_xy = 0.0;
};

/// Positions of a player in live frames, as the team sees the pitch (it attacks +x).
struct Positions {
  Cloud all;
  soccer::Vec2 mean_own_ball;  ///< while the own team owns the ball
  soccer::Vec2 mean_opponent_ball;
  HeatMap heat = {};  ///< not mirrored: as the left team sees the pitch
};

/// Means over every tenth live frame; connected players except the goalie.
struct TeamShape {
  double length = 0.0;  ///< meters along the pitch
  double width = 0.0;
  double hull_area = 0.0;      ///< square meters
  double compactness = 0.0;    ///< mean distance from the team's center
  double defense_x = 0.0;      ///< mean x of the three rearmost players, as the team sees the pitch
  double line_distance = 0.0;  ///< between the lines of the formation
  std::string formation{};     ///< "4-3-3": lines from the rear by mean positions; may be empty
};

struct PositionStats {
  PerPlayer<Positions> players;
  PerTeam<TeamShape> teams;
  HeatMap ball = {};
};

PositionStats measure_positions(const Flow& flow);

/// Accumulates the shape of one team over frames.
class ShapeAccumulator {
 public:
  void add(const gamelog::MatchRecord& record, std::size_t frame, std::size_t team);

  /// Means over the added frames; formation and line distance are not set.
  TeamShape shape() const;

 private:
  TeamShape sum_;
  int count_ = 0;
};

/// Area of the convex hull.
double hull_area(std::vector<soccer::Vec2> points);

/// Splits the players into lines from rear to front, at the two or three widest gaps of their mean
/// x (at the third only if it is wide).
void set_formation(std::vector<double> mean_x, TeamShape& shape);

}  // namespace cls::analysis
