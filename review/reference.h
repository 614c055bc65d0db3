// The statistics in which a team is farthest from a reference team.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "review/estimate.h"
#include "soccer/side.h"

namespace cls::review {

/// The figures of a team in one match, in the order of the statistics that are compared; counts are
/// those of a match of 6000 cycles. NaN: the match has no such figure.
using Figures = std::vector<double>;
Figures figures_of(const analysis::MatchSummary& summary,
                   const analysis::MatchStatistics& statistics, soccer::Side side);

/// A statistic of the team and of the reference, each a mean over its matches.
struct Difference {
  const char* statistic = "";  ///< "passes completed"
  const char* unit = "";       ///< "goals", "%", "m"; empty for counts
  double team = 0.0;
  double reference = 0.0;
  Estimate difference;  ///< team - reference
  double errors = 0.0;  ///< the difference, in standard errors

  /// The interval does not contain 0.
  bool certain() const { return difference.low > 0.0 || difference.high < 0.0; }
};

/// Welch's test of every statistic that both have in two matches or more, farthest first. The
/// intervals hold together: with a chance of 95 % all of them contain the true difference
/// (Bonferroni), so that the farthest of many is not luck. Statistics without any variation are
/// left out.
std::vector<Difference> differences(const std::vector<Figures>& team,
                                    const std::vector<Figures>& reference);

}  // namespace cls::review
