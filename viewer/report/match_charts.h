// The charts of a match, from its statistics.
#pragma once

#include <string>
#include <vector>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"

namespace cls::viewer {

/// An SVG image without a style sheet (charts/drawing.h).
struct Chart {
  std::string name;  ///< of a file, without suffix: "shot-map", "goal-1"
  std::string title;
  std::string svg;
};

/// xG race, possession and field tilt, shots, pass networks, heat maps, and a scene for each of the
/// first goals, in this order. `summary` and `statistics` are of the same match.
std::vector<Chart> match_charts(const analysis::MatchSummary& summary,
                                const analysis::MatchStatistics& statistics);

/// The name of a team (0 left, 1 right), or "left team" without one.
std::string team_label(const analysis::MatchSummary& summary, std::size_t team);

}  // namespace cls::viewer
