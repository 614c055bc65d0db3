// Match statistics as JSON.
#pragma once

#include <string>
#include <vector>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"

namespace cls::analysis {

/// One match of the document, schema "cls.stats/1" (docs/formats/statistics.md), indented as an
/// element of its array. With `events`, every pass, carry, shot, tackle and foul one by one.
std::string statistics_json(const MatchSummary& summary, const MatchStatistics& statistics,
                            bool events);

/// The whole document around elements made by the above.
std::string statistics_document(const std::vector<std::string>& matches);

}  // namespace cls::analysis
