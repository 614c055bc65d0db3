// How likely shots are to score.
#pragma once

#include <vector>

#include "analysis/play/flow.h"
#include "analysis/play/shots.h"

namespace cls::analysis {

/// What the estimate looks at, at the moment of the shot.
struct ShotSituation {
  double distance = 0.0;      ///< metres to the goal's centre
  double opening = 0.0;       ///< radians between the posts, seen from the ball
  double cycles = 0.0;        ///< until the ball crosses the line
  int opponents_between = 0;  ///< in the triangle of ball and posts, goalkeeper not counted
  /// Metres that the goalkeeper lacks to meet the ball on its way; below 0: he gets there.
  double keeper_margin = 0.0;
};

ShotSituation situation_of(const Flow& flow, const Shot& shot);

/// Probability of a goal: a logistic function with start values that are not fitted to data
/// (match-statistics 3.5): 1.2 - 0.12 distance + 1.0 opening - 0.35 cycles, and 0.6 more if the
/// goalkeeper does not get there.
double goal_probability(const ShotSituation& situation);

/// One entry a shot.
std::vector<double> expected_goals(const Flow& flow, const std::vector<Shot>& shots);

}  // namespace cls::analysis
