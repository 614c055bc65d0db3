// Formats match statistics as JSON.
#pragma once

#include <string>
#include <vector>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"

namespace cls::analysis {

/// One match of the document "cls.stats/1" (docs/formats/statistics.md). With `events`, includes
/// every pass, carry, shot, tackle and foul.
std::string statistics_json(const MatchSummary& summary, const MatchStatistics& statistics,
                            bool events);

/// The document of matches formatted by statistics_json().
std::string statistics_document(const std::vector<std::string>& matches);

}  // namespace cls::analysis
