// What all decisions with the ball lost, by kind and situation: where a team should begin to look.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/statistics/match_statistics.h"
#include "review/chances.h"
#include "review/decisions.h"
#include "review/estimate.h"

namespace cls::review {

inline constexpr double kPressedRange = 3.0;  ///< meters from the ball to the nearest opponent

/// A decision, and what the value of the moment lost until the next decision of the team, a goal,
/// or kDecisionHorizon cycles later, whichever comes first.
struct Loss {
  std::string name;  ///< what, where and whether pressed: "pass in own third, pressed"
  int cycle = 0;
  double goals = 0.0;  ///< negative: the moment gained
};

/// Of `decisions`, all those of `side` in a match.
std::vector<Loss> losses_of(const analysis::MatchStatistics& match,
                            const std::vector<Decision>& decisions, soccer::Side side);

/// Decisions of one name.
struct LossClass {
  std::string name;
  std::size_t decisions = 0;
  Estimate goals;  ///< sum over all matches
  Place worst;     ///< where most was lost
};

/// By goals, highest first; `losses` by match. Each loss ends where the next begins at the latest,
/// so the interval takes them as independent: their variances add up.
std::vector<LossClass> classes_of(const std::vector<std::vector<Loss>>& losses);

}  // namespace cls::review
