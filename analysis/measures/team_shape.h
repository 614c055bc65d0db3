// The shape of ten players.
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/measures/positions.h"
#include "gamelog/record/match_record.h"
#include "soccer/geometry.h"

namespace cls::analysis {

/// Adds up the shape of one team over frames.
class ShapeMeter {
 public:
  void add(const gamelog::MatchRecord& record, std::size_t frame, std::size_t team);

  /// Means over the frames that were added; formation and lines are left empty.
  TeamShape shape() const;

 private:
  TeamShape sum_;
  int count_ = 0;
};

/// Area of the convex hull.
double hull_area(std::vector<soccer::Vec2> points);

/// Splits the players at the two or three widest gaps of their mean x (the third only if it is
/// wide) into lines, rear to front.
void set_formation(std::vector<double> mean_x, TeamShape& shape);

}  // namespace cls::analysis
