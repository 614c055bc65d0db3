// Goal probabilities of shots (xG).
#pragma once

#include <vector>

#include "analysis/play/flow.h"
#include "analysis/play/shots.h"

namespace cls::analysis {

/// Inputs of the estimate at the time of the shot.
struct ShotSituation {
  double distance = 0.0;      ///< meters to the goal's center
  double opening = 0.0;       ///< radians between the posts, seen from the ball
  double cycles = 0.0;        ///< until the ball crosses the line
  int opponents_between = 0;  ///< in the triangle of ball and posts, without the goalie
  /// Meters that the goalie lacks to reach the ball's path; negative: reaches it.
  double goalie_margin = 0.0;
};

ShotSituation situation_of(const Flow& flow, const Shot& shot);

/// Probability of a goal: a logistic function with initial coefficients, not fitted to data
/// (docs/spec/match-statistics.md 3.5): 1.2 - 0.12 distance + 1.0 opening - 0.35 cycles, and 0.6
/// more if the goalie does not reach the ball's path.
double goal_probability(const ShotSituation& situation);

/// One entry per shot.
std::vector<double> expected_goals(const Flow& flow, const std::vector<Shot>& shots);

}  // namespace cls::analysis
